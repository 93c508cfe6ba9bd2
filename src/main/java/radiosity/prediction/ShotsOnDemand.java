package radiosity.prediction;

import java.util.AbstractList;
import java.util.function.IntFunction;
import radiosity.protocol.Shot;
import radiosity.util.ParallelFor;

/**
 * A list of shots that are made when they are first asked for, a few at a time, so that hosts can carry out the first
 * shots while later ones are being made. Any number of threads may read the list.
 */
public final class ShotsOnDemand extends AbstractList<Shot> {

    /** Number of shots that are made together. */
    private static final int AT_A_TIME = 4;

    private final Shot[] made;
    private final IntFunction<Shot> make;
    private final ParallelFor parallel;

    /** @param make makes the shot with a number; called by any thread */
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
