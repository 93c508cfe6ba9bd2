package radiosity.partition;

import java.util.List;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;

/**
 * One part of a world (section 4.5.4 of the paper): some blocks of elements, and the operations of a round on them.
 *
 * <p>A world in the same process calls a partition, or a worker calls it for a master on another machine; one thread at
 * a time.
 */
public interface Partition {

    /**
     * Carries out a round, or a part of one.
     *
     * @param order the order, with the radiosity of all its shots
     * @return sums and candidates after the order; an empty answer where the order is not
     *         {@linkplain Order#isAnswered answered}
     */
    Answer answer(Order order);

    /** Carries out an order of any kind; returns an {@link Answer} as bytes, or the data that the order asks for. */
    byte[] round(Order order);

    /** Per shooter: the radiosity that its elements have shot in all rounds. */
    List<Shot> totals();

    /** The state of an owned block: trees, irradiance of their vertices, radiosity that their elements have shot. */
    byte[] block(int id);

    /** Replaces the state of an owned block by one that {@link #block} returned. */
    void restore(int id, byte[] state);
}
