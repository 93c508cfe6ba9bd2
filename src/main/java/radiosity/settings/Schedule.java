package radiosity.settings;

/** In which order patches shoot. */
public enum Schedule {
    /** Every patch shoots its predicted total once, then what was mispredicted. */
    PREDICT,
    /** Shooting and sorting (section 2.2 of the paper): most unshot flux first. */
    PAPER,
    /** Shooting (section 2.2 of the paper): every patch in turn. */
    SHOOTING,
    /** Gathering (section 2.2 of the paper): every patch receives what all have, sweep by sweep. */
    GATHERING,
    /** The whole linear system at once (section 2.1 of the paper). */
    MATRIX;

    /** Most patches for the last three, which look at all pairs of them or at all patches in every round. */
    public static final int MOST_PATCHES = 10_000;

    /** Whether it is meant for scenes of at most {@link #MOST_PATCHES} patches. */
    public boolean isForSmallScenes() {
        return this == SHOOTING || this == GATHERING || this == MATRIX;
    }
}
