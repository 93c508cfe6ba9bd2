package radiosity.world;

import java.rmi.Remote;
import java.rmi.RemoteException;

/**
 * One part of a world (section 4.5.4 of the paper): some blocks of elements, and what is done to them in every round.
 *
 * <p>Arguments and results are bytes, so that the same calls go to a partition in this process and to one on another
 * machine.
 */
public interface Partition extends Remote {

    /**
     * Updates all elements for the shots of a round, and says what could shoot next.
     *
     * @param shots shots in the order in which they are applied, as written by {@link Wire}; none: only answer
     * @param most  how many candidates to name
     * @return the answer, as written by {@link Wire}
     */
    byte[] shoot(byte[] shots, int most) throws RemoteException;

    /** Everything about a block: its trees, what their vertices have received, what their elements have shot. */
    byte[] block(int id) throws RemoteException;

    /** Puts a block that this partition owns back to what {@link #block} had given. */
    void restore(int id, byte[] state) throws RemoteException;
}
