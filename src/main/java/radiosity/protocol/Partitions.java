package radiosity.protocol;

import java.io.IOException;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** All partitions of a world, for callers who ask them but change nothing. */
public interface Partitions {

    /** Receives the encoded answers of all partitions to an order. */
    interface Answers {
        void take(Order order, List<byte[]> answers) throws IOException;
    }

    /**
     * Has all partitions carry out orders that change no element, and passes on their answers in the sequence of the
     * orders. An order may be fetched while the answers to earlier orders are on their way.
     *
     * @param goOn called now and then, by the calling thread only
     * @throws IOException           where a partition cannot be reached
     * @throws CancellationException where {@code goOn} returns false
     */
    void ask(Iterator<Order> orders, Answers answers, BooleanSupplier goOn) throws IOException;
}
