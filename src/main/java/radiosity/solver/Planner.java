package radiosity.solver;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;

/** Decides who shoots in the next round; a schedule at work. */
public sealed interface Planner permits ShootAndSort, Prediction, CyclicSchedule, MatrixSolution {

    /**
     * The next round.
     *
     * @param last   what the partitions answered to the last one
     * @param unsent unshot flux relative to the emitted
     * @param goOn   asked now and then where it takes long to decide; changes nothing
     * @return what to do, or null where nothing is left, or where it was not to go on
     */
    Order next(Answer last, double unsent, BooleanSupplier goOn) throws IOException;

    /** Receives what the partitions answered to an order for {@link Order.Kind#ROWS}, or to a part of one. */
    default void take(int shots, List<byte[]> rows) throws IOException { }

    /** Whether rounds overlap: the next one is chosen from what was known before the present one. */
    default boolean looksAhead() {
        return false;
    }

    /** How many candidates partitions are to name where nothing is known of them. */
    default int wanted() {
        return Integer.MAX_VALUE;
    }

    /**
     * Whether the calculation is at its end.
     *
     * @param last   what the partitions answered to the last round
     * @param unsent unshot flux relative to the emitted
     * @param wanted the same at which to stop
     */
    default boolean isEnough(Answer last, double unsent, double wanted) {
        return unsent <= wanted;
    }

    /** Relative error at which the calculation may end; nothing where that is not looked at. */
    default OptionalDouble aim() {
        return OptionalDouble.empty();
    }

    /** Asks for less error than before, if that is looked at. */
    default void aim(double error) { }

    /** What resuming needs beside the elements. */
    default void write(DataOutput out) throws IOException { }

    default void read(DataInput in) throws IOException { }
}
