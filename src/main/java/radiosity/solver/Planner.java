package radiosity.solver;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;

/** A schedule at work: chooses the shots of the next round. */
public sealed interface Planner permits ShootAndSort, Prediction, CyclicSchedule, MatrixSolution {

    /**
     * The next round.
     *
     * @param last   the sum of the partitions' answers to the last round
     * @param unsent unshot flux over emitted flux
     * @param goOn   called now and then during a long choice, without influence on the choice
     * @return the order, or null where no light is left to shoot or {@code goOn} returned false
     */
    Order next(Answer last, double unsent, BooleanSupplier goOn) throws IOException;

    /** Receives the partitions' answers to an order for {@link Order.Kind#ROWS}, or to a part of the order. */
    default void take(int shots, List<byte[]> rows) throws IOException { }

    /** Whether rounds overlap: the next round is chosen by the answer to the round before the present one. */
    default boolean looksAhead() {
        return false;
    }

    /** Number of candidates that partitions name in their first answer. */
    default int wanted() {
        return Integer.MAX_VALUE;
    }

    /**
     * Whether the calculation is at its end.
     *
     * @param last   the sum of the partitions' answers to the last round
     * @param unsent unshot flux over emitted flux
     * @param wanted unshot flux over emitted flux at which to stop
     */
    default boolean isEnough(Answer last, double unsent, double wanted) {
        return unsent <= wanted;
    }

    /** Relative error at which the calculation may end; empty where the schedule estimates no error. */
    default OptionalDouble aim() {
        return OptionalDouble.empty();
    }

    /** Lowers the relative error asked for; nothing happens where the schedule estimates no error. */
    default void aim(double error) { }

    /** Writes the state of the schedule that a resumed calculation needs. */
    default void write(DataOutput out) throws IOException { }

    default void read(DataInput in) throws IOException { }
}
