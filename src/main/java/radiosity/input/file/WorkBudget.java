package radiosity.input.file;

/**
 * Limits the work of cutting polygons into triangles, in steps of some nanoseconds. The budget is a reserve, for
 * polygons that cost far more than their number of corners suggests, and an allowance for each corner.
 */
public final class WorkBudget {

    private static final long RESERVE = 100_000_000;
    private static final long PER_CORNER = 300;

    private long left = RESERVE;

    /** Adds the allowance for corners that are to be cut. */
    public void grant(int corners) {
        left = Math.min(Long.MAX_VALUE / 2, left + PER_CORNER * corners);
    }

    public void spend(long steps) {
        left -= steps;
    }

    public boolean isSpent() {
        return left < 0;
    }
}
