package radiosity.rmi;

import java.rmi.Remote;
import java.rmi.RemoteException;

/**
 * The remote interface of a host, which {@code PartitionServer} exports, and by which the calls of a {@code
 * RemoteWorld} reach a {@code Partition} on another machine: in sessions, with large messages in parts, and so that
 * {@link #round} and {@link #blocks} may be repeated.
 *
 * <p>Arguments are numbers and arrays of bytes only, so that a host can refuse all other objects. All calls but {@link
 * #greet} and {@link #open} name the session to which they belong; a host has one session at a time. A call for a
 * session that has ended throws a {@link SessionEndedException}.
 */
public interface RemotePartition extends Remote {

    /** Largest number of rounds that a master has in flight; a host keeps as many replies, see {@link #round}. */
    int MOST_IN_FLIGHT = 4;
    /** Largest number of bytes of an array: memory for an array is allocated before its bytes arrive. */
    int MOST_PIECE_BYTES = 1 << 20;

    /** The host's {@code Greeting}, as bytes; also ends a session whose master has been silent for a while. */
    byte[] greet() throws RemoteException;

    /**
     * Begins a session. Throws an IllegalStateException while another session is alive.
     *
     * @param session number that the master has chosen at random
     * @param master  name of the user for whom the host works, in UTF-8; other masters are shown this name
     */
    void open(long session, byte[] master) throws RemoteException;

    /** The heartbeat: master and host each learn that the other is alive. Never waits for the computation. */
    void ping(long session) throws RemoteException;

    /** Appends to the message that {@link #mesh}, {@link #take}, {@link #know} or {@link #share} will read. */
    void send(long session, byte[] part) throws RemoteException;

    /** Makes the initial mesh of the scene that was sent, see {@code SceneBytes}; gives its fingerprint in UTF-8. */
    byte[] mesh(long session) throws RemoteException;

    /**
     * Makes the blocks that were sent the host's own and brings them up to date; gives up other blocks. The message
     * that was sent is a {@code BlockTakeover}.
     *
     * @return for each order in the message that asks for an answer: number of bytes, then an {@code Answer}
     */
    byte[] take(long session) throws RemoteException;

    /** Replaces all light ever shot, as the host knows it, by the message that was sent. */
    void know(long session) throws RemoteException;

    /** The keys of the vertices that other hosts may also have, 8 bytes each, see {@code GhostVertices.name}. */
    byte[] border(long session) throws RemoteException;

    /** Takes from the message that was sent which host gathers at these vertices, see {@code GhostVertices.agree}. */
    void share(long session) throws RemoteException;

    /**
     * Carries out an order on the blocks that the host owns. A call that repeats a number gets the same reply again.
     *
     * @param number 1, 2, ... in a session; orders that change elements and orders that only ask are counted alike
     * @param order  in pieces of at most {@link #MOST_PIECE_BYTES} bytes: an order for {@code Partition.round}, then
     *               the ghost values for this host, if there are any, see {@code GhostVertices}
     * @return a {@code Reply}
     */
    byte[] round(long session, long number, byte[][] order) throws RemoteException;

    /**
     * The states of blocks.
     *
     * @param blocks ids of blocks, 4 bytes each
     * @return for each of the first of these blocks, as many as go into one answer: number of bytes, then the state
     */
    byte[] blocks(long session, byte[] blocks) throws RemoteException;

    /** Ends the session and frees its memory; does nothing where the session has ended. */
    void close(long session) throws RemoteException;
}
