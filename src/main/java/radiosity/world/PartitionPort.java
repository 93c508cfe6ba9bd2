package radiosity.world;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.ExportException;
import java.rmi.server.UnicastRemoteObject;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * Where a host serves masters (section 4.5.6 of the paper): a registry and a partition on one port.
 *
 * <p>Where the port belongs to an {@code rmiregistry} that runs already, as in appendix C.3, that one is used, and the
 * partition has a port of its own. What is bound is the bare handler of the stub, a class of the JDK: a registry that
 * was started elsewhere does not know {@link RemotePartition}.
 */
public final class PartitionPort implements AutoCloseable {

    static final String NAME = "Partition";
    private static final int LOOK_SECONDS = 2;

    /** Kept, or it would be collected as garbage. */
    private final ServedPartition served;
    private final Registry registry;
    private final boolean ownRegistry;
    private final int port;
    private final Thread look = new Thread(this::look, "gone masters");

    private PartitionPort(ServedPartition served, Registry registry, boolean ownRegistry, int port) {
        this.served = served;
        this.registry = registry;
        this.ownRegistry = ownRegistry;
        this.port = port;
        look.setDaemon(true);
        look.start();
    }

    /**
     * How to serve.
     *
     * @param registryPort   where masters look first
     * @param partitionPort  the partition's own where the registry is another program; 0 for any
     * @param bind           address to listen on; null for all of this machine's
     * @param key            null for none
     * @param threads        to compute with
     */
    public record Options(int registryPort, int partitionPort, InetAddress bind, HostKey key, int threads) { }

    /**
     * Serves from now on.
     *
     * @param log told about masters, one line each
     * @throws RemoteException where the ports cannot be had
     */
    public static PartitionPort open(Options options, Consumer<String> log) throws IOException {
        RmiSockets sockets = RmiSockets.inUse();
        sockets.listen(options.registryPort(), options.bind(), options.key());
        ServedPartition served = new ServedPartition(options.threads(), log);
        try {
            Registry own = LocateRegistry.createRegistry(options.registryPort());
            return export(served, own, true, options.registryPort());
        } catch (ExportException e) {
            return behind(options, sockets, served, e);
        }
    }

    /** The port is taken: by a registry? */
    private static PartitionPort behind(Options options, RmiSockets sockets, ServedPartition served,
                                        ExportException taken) throws IOException {
        Registry other = LocateRegistry.getRegistry("localhost", options.registryPort());
        try {
            for (String name : other.list()) {
                if (name.equals(NAME)) {
                    refuseSecond(other, taken);
                }
            }
        } catch (RemoteException e) {
            throw taken;
        }
        sockets.listen(options.partitionPort(), options.bind(), options.key());
        return export(served, other, false, options.partitionPort());
    }

    /** A name that is left from a server that has ended may be taken over. */
    private static void refuseSecond(Registry registry, ExportException taken) throws IOException {
        try {
            if (registry.lookup(NAME) instanceof java.rmi.server.RemoteObjectInvocationHandler handler) {
                RemotePartition other = (RemotePartition) Proxy.newProxyInstance(
                        RemotePartition.class.getClassLoader(), new Class<?>[] {RemotePartition.class}, handler);
                other.greet();
                throw taken;
            }
        } catch (ExportException e) {
            throw e;
        } catch (RemoteException | java.rmi.NotBoundException e) {
            // nobody is there any more
        }
    }

    private static PartitionPort export(ServedPartition served, Registry registry, boolean own, int port)
            throws RemoteException {
        Remote stub = UnicastRemoteObject.exportObject(served, port, null, null, SerialFilters::ofHost);
        registry.rebind(NAME, (Remote) Proxy.getInvocationHandler(stub));
        try {
            int used = HostStub.of((java.rmi.server.RemoteObjectInvocationHandler) Proxy.getInvocationHandler(stub)).port();
            return new PartitionPort(served, registry, own, used);
        } catch (IOException e) {
            throw new RemoteException("stub", e);
        }
    }

    /** Where the partition listens: the registry's port, or another one beside a registry that was there before. */
    public int port() {
        return port;
    }

    private void look() {
        try {
            while (true) {
                TimeUnit.SECONDS.sleep(LOOK_SECONDS);
                served.expire();
            }
        } catch (InterruptedException e) {
            // closed
        }
    }

    @Override
    public void close() throws RemoteException {
        look.interrupt();
        try {
            registry.unbind(NAME);
        } catch (java.rmi.NotBoundException | RemoteException e) {
            // it is gone already
        }
        UnicastRemoteObject.unexportObject(served, true);
        if (ownRegistry) {
            unexport();
        }
    }

    private void unexport() {
        try {
            UnicastRemoteObject.unexportObject(registry, true);
        } catch (NoSuchObjectException e) {
            // it is gone already
        }
    }
}
