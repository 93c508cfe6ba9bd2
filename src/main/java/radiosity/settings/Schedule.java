package radiosity.settings;

/** Order in which patches shoot. */
public enum Schedule {
    /** Every patch shoots its predicted total once, then the light that was predicted wrongly. */
    PREDICT,
    /** Shooting and sorting (section 2.2 of the paper): most unshot flux first. */
    PAPER,
    /** Shooting (section 2.2 of the paper): every patch in turn. */
    SHOOTING,
    /** Gathering (section 2.2 of the paper): in every sweep every patch receives the light of all patches. */
    GATHERING,
    /** The whole linear system is solved at once (section 2.1 of the paper). */
    MATRIX;

    /** Largest number of patches for the last three schedules, which visit all patches or pairs in every round. */
    public static final int MOST_PATCHES = 10_000;

    /** Whether this schedule is limited to scenes of at most {@link #MOST_PATCHES} patches. */
    public boolean isForSmallScenes() {
        return this == SHOOTING || this == GATHERING || this == MATRIX;
    }
}
