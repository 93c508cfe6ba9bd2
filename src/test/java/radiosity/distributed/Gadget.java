package radiosity.distributed;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.rmi.Remote;
import java.util.concurrent.atomic.AtomicInteger;

/** Stands for any class whose deserialization does harm: it counts how often it was made from a stream. */
final class Gadget extends RuntimeException implements Remote, Serializable {

    static final AtomicInteger MADE = new AtomicInteger();
    private static final long serialVersionUID = 1;

    private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
        MADE.incrementAndGet();
        in.defaultReadObject();
    }
}
