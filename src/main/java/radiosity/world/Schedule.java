package radiosity.world;

/** In which order patches shoot. */
public enum Schedule {
    /** Every patch shoots its predicted total once, then what was mispredicted. */
    PREDICT,
    /** Shooting and sorting (section 2.2 of the paper): most unshot flux first. */
    PAPER
}
