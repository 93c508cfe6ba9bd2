package radiosity.formfactor;

/**
 * Sample points of the R2 sequence (M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018), in
 * whole numbers of 32 bits, and lots for choosing among them.
 */
final class R2 {

    /** What a point's coordinates grow by from one to the next. */
    static final int U = 0xC13FA9A9;
    static final int V = 0x91E10DA6;

    private R2() { }

    /** A number in [0, 1) of 24 bits. */
    static float unit(int bits) {
        return (bits >>> 8) * 0x1p-24f;
    }

    /** What turns a point of the unit square beyond its diagonal back into the triangle; without a branch. */
    static int fold(int u, int v) {
        return -((u >>> 8) + (v >>> 8) >>> 24);
    }

    /** Where a sequence of lots begins. */
    static int lot(long rotation) {
        return (int) (rotation * 0x9E3779B97F4A7C15L >>> 32);
    }

    /** The lot after one. Source: W. Press and others, Numerical Recipes, 1992, 7.1. */
    static int next(int lot) {
        return lot * 1664525 + 1013904223;
    }
}
