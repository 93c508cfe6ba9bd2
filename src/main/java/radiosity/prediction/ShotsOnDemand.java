package radiosity.prediction;

import java.util.AbstractList;
import java.util.function.IntFunction;
import radiosity.protocol.Shot;
import radiosity.util.ParallelFor;

/** Shots of which a few are made when the first of them is asked for, as others are carried out meanwhile. */
public final class ShotsOnDemand extends AbstractList<Shot> {

    /** Made together. */
    private static final int AT_A_TIME = 4;

    private final Shot[] made;
    private final IntFunction<Shot> make;
    private final ParallelFor parallel;

    /** @param make from any thread */
    public ShotsOnDemand(int size, IntFunction<Shot> make, ParallelFor parallel) {
        made = new Shot[size];
        this.make = make;
        this.parallel = parallel;
    }

    @Override
    public synchronized Shot get(int i) {
        if (made[i] == null) {
            parallel.run(Math.min(AT_A_TIME, made.length - i), k -> made[i + k] = make.apply(i + k));
        }
        return made[i];
    }

    @Override
    public int size() {
        return made.length;
    }
}
