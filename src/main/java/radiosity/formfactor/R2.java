package radiosity.formfactor;

/**
 * Sample points of the R2 sequence (M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018) as
 * 32-bit fractions of 1, and pseudo-random numbers (lots) for choosing among the points.
 */
final class R2 {

    /** Differences between the coordinates of consecutive points, modulo 2^32. */
    static final int U = 0xC13FA9A9;
    static final int V = 0x91E10DA6;

    private R2() { }

    /** The upper 24 bits as a number in [0, 1). */
    static float unit(int bits) {
        return (bits >>> 8) * 0x1p-24f;
    }

    /** Mask for an exclusive or with u and v, which mirrors points with u + v of 1 or more into the triangle. */
    static int fold(int u, int v) {
        return -((u >>> 8) + (v >>> 8) >>> 24);
    }

    /** The first of a sequence of lots. */
    static int lot(long rotation) {
        return (int) (rotation * 0x9E3779B97F4A7C15L >>> 32);
    }

    /** The next lot of the sequence. Source: W. Press and others, Numerical Recipes, 1992, 7.1. */
    static int next(int lot) {
        return lot * 1664525 + 1013904223;
    }
}
