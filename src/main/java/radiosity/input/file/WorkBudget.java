package radiosity.input.file;

/**
 * What the cutting of polygons may cost in a whole scene, in steps of some nanoseconds: a sum that grows with what
 * there is to cut, and one reserve for polygons that cost far more than their corners should.
 */
public final class WorkBudget {

    private static final long RESERVE = 100_000_000;
    private static final long PER_CORNER = 300;

    private long left = RESERVE;

    /** More corners are there to be cut. */
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
