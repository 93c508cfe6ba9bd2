package radiosity.partition;

import java.rmi.Remote;
import java.rmi.RemoteException;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;

/**
 * One part of a world (section 4.5.4 of the paper): some blocks of elements, and what is done to them in every round.
 *
 * <p>Arguments and results are bytes, so that the same calls go to a partition in this process and to one on another
 * machine.
 */
public interface Partition extends Remote {

    /**
     * One round.
     *
     * @param order what to do, as written by {@link Order}
     * @return an {@link Answer}, or what else the order asks for
     */
    byte[] round(byte[] order) throws RemoteException;

    /** Everything about a block: its trees, what their vertices have received, what their elements have shot. */
    byte[] block(int id) throws RemoteException;

    /** Puts a block that this partition owns back to what {@link #block} had given. */
    void restore(int id, byte[] state) throws RemoteException;
}
