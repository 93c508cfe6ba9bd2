package radiosity.master.balance;

/**
 * When to do something that costs time but may save more later: when what it could save has grown to a multiple of
 * what it cost the last time.
 */
public final class AmortizedTrigger {

    private final double multiple;
    private final double leastCost;
    private double cost;
    private double gain;

    /**
     * @param leastCost what it is taken to cost at least, once it was done, s
     * @param firstCost what it is taken to cost before, s
     */
    public AmortizedTrigger(double multiple, double leastCost, double firstCost) {
        this.multiple = multiple;
        this.leastCost = leastCost;
        cost = firstCost;
    }

    /** @param seconds that doing it now would save, beside what was added before */
    public void add(double seconds) {
        gain += seconds;
    }

    public boolean isDue() {
        return isDue(0);
    }

    /** @param ahead seconds that doing it now would save for certain, from now on */
    boolean isDue(double ahead) {
        return gain + ahead >= multiple * cost;
    }

    /** It was looked at, and nothing was to be saved. */
    void inVain() {
        cost *= 2;
        gain = 0;
    }

    /** It was done. */
    public void done(double seconds) {
        cost = Math.max(leastCost, seconds);
        gain = 0;
    }
}
