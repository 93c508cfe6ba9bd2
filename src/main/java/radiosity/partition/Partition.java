package radiosity.partition;

import java.util.List;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;

/**
 * One part of a world (section 4.5.4 of the paper): some blocks of elements, and what is done to them in every round.
 *
 * <p>A world in this process calls it; a host calls it for a master on another machine.
 */
public interface Partition {

    /**
     * One round, or a part of one.
     *
     * @param order what to do, with all that is shot
     * @return how things stand then; nothing where the order is not {@linkplain Order#isAnswered answered}
     */
    Answer answer(Order order);

    /** Carries out an order of any kind: gives an {@link Answer} as bytes, or what else the order asks for. */
    byte[] round(Order order);

    /** What each shooter has ever shot. */
    List<Shot> totals();

    /** Everything about a block: its trees, what their vertices have received, what their elements have shot. */
    byte[] block(int id);

    /** Puts a block that this partition owns back to what {@link #block} had given. */
    void restore(int id, byte[] state);
}
