package radiosity.rmi;

import java.rmi.Remote;
import java.rmi.RemoteException;
import radiosity.master.RemoteWorld;
import radiosity.partition.GhostVertices;
import radiosity.partition.Partition;
import radiosity.protocol.Answer;
import radiosity.protocol.BlockTakeover;
import radiosity.protocol.Greeting;
import radiosity.protocol.Reply;
import radiosity.protocol.SceneBytes;

/**
 * How the calls of a {@link RemoteWorld} come to a {@link Partition} on another machine, for which {@code
 * PartitionServer} exports this: in sessions, with messages in parts, and so that a call may be repeated.
 *
 * <p>Arguments are numbers and bytes only, so that a host can refuse whatever else is sent. All calls but
 * {@link #greet} and {@link #open} name the session that they belong to; a host has one at a time.
 */
public interface RemotePartition extends Remote {

    /** Who is there, see {@link Greeting}; costs nothing and changes nothing. */
    byte[] greet() throws RemoteException;

    /**
     * Begins a session. Fails while another master's session is alive.
     *
     * @param master for whom, as UTF-8, for the message to others
     */
    void open(long session, byte[] master) throws RemoteException;

    /** Tells that the master is alive, and the master that this host is. Never waits for the computation. */
    void ping(long session) throws RemoteException;

    /** Appends to the message that {@link #mesh}, {@link #take} or {@link #know} will read. */
    void send(long session, byte[] part) throws RemoteException;

    /** Makes the initial mesh of the scene that was sent, see {@link SceneBytes}; answers its fingerprint as UTF-8. */
    byte[] mesh(long session) throws RemoteException;

    /**
     * Makes the blocks its own that were sent, see {@link BlockTakeover}, and brings them up to date; gives others up.
     *
     * @return for each order that is answered: number of bytes, then an {@link Answer}
     */
    byte[] take(long session) throws RemoteException;

    /** Takes all that was ever shot from the message that was sent. */
    void know(long session) throws RemoteException;

    /** The keys of the vertices that other hosts may have, too, see {@link GhostVertices#name}. */
    byte[] border(long session) throws RemoteException;

    /** Takes from the message that was sent who gathers at which of them, see {@link GhostVertices#agree}. */
    void share(long session) throws RemoteException;

    /**
     * One round on the blocks that this host owns. The same number again is not done again.
     *
     * @param number 1, 2, ... in a session; what changes elements and what only asks is counted alike
     * @param order  as {@link Partition#round} takes it, then what others have gathered for this host, see {@link
     *               GhostVertices}; or nothing
     * @return a {@link Reply}
     */
    byte[] round(long session, long number, byte[] order) throws RemoteException;

    /**
     * The states of blocks.
     *
     * @param blocks ids, 4 bytes each
     * @return for as many of them, from the first, as go into one answer: number of bytes, then those
     */
    byte[] blocks(long session, byte[] blocks) throws RemoteException;

    /** Ends a session and frees its memory. */
    void close(long session) throws RemoteException;
}
