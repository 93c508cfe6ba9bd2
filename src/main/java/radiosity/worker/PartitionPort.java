package radiosity.worker;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.rmi.NoSuchObjectException;
import java.rmi.NotBoundException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.UnmarshalException;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.ExportException;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.rmi.server.UnicastRemoteObject;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import radiosity.rmi.HostKey;
import radiosity.rmi.HostStub;
import radiosity.rmi.RemotePartition;
import radiosity.rmi.RmiSockets;
import radiosity.rmi.SerialFilters;

/**
 * Where a host serves masters (section 4.5.6 of the paper): a registry and a partition on one port.
 *
 * <p>Where the port belongs to an {@code rmiregistry} that runs already, as in appendix C.3, that one is used, and the
 * partition has a port of its own. What is bound is the bare handler of the stub, a class of the JDK: a registry that
 * was started elsewhere does not know {@link RemotePartition}.
 */
public final class PartitionPort implements AutoCloseable {

    public static final String NAME = "Partition";
    private static final int LOOK_SECONDS = 2;

    /** Kept, or it would be collected as garbage. */
    private final ServedPartition served;
    private final Registry registry;
    private final boolean ownRegistry;
    /** What the registry has under {@link #NAME}. */
    private final RemoteObjectInvocationHandler bound;
    private final int port;
    private final Consumer<String> log;
    /** What was wrong with the registry when it was looked at last; null where masters find this partition by it. */
    private String trouble;
    private final Thread look = new Thread(() -> everyTime(this::expire), "gone masters");
    /** A thread of its own, as a registry of another program may keep it waiting. */
    private final Thread registryLook = new Thread(() -> everyTime(this::keepBound), "registry");

    private PartitionPort(ServedPartition served, Registry registry, boolean ownRegistry,
                          RemoteObjectInvocationHandler bound, Consumer<String> log) throws IOException {
        this.served = served;
        this.registry = registry;
        this.ownRegistry = ownRegistry;
        this.bound = bound;
        this.log = log;
        port = HostStub.of(bound).port();
        for (Thread thread : List.of(look, registryLook)) {
            thread.setDaemon(true);
            thread.start();
        }
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
     * @param log gets one line for each master that comes or goes
     * @throws RemoteException where the ports cannot be had
     */
    public static PartitionPort open(Options options, Consumer<String> log) throws IOException {
        RmiSockets sockets = RmiSockets.inUse();
        sockets.listen(options.registryPort(), options.bind(), options.key());
        ServedPartition served = new ServedPartition(options.threads(), log);
        try {
            Registry own = LocateRegistry.createRegistry(options.registryPort());
            return export(served, own, true, options.registryPort(), log);
        } catch (ExportException e) {
            return behind(options, sockets, served, e, log);
        }
    }

    /** The port is taken: by a registry? */
    private static PartitionPort behind(Options options, RmiSockets sockets, ServedPartition served,
                                        ExportException taken, Consumer<String> log) throws IOException {
        SerialFilters.ofMaster();
        Registry other = LocateRegistry.getRegistry("localhost", options.registryPort());
        try {
            if (isServed(other)) {
                throw taken;
            }
        } catch (RemoteException e) {
            throw taken;
        }
        sockets.listen(options.partitionPort(), options.bind(), options.key());
        return export(served, other, false, options.partitionPort(), log);
    }

    /**
     * Whether the name leads to a partition that answers. One that is left from a server that has ended may be
     * replaced.
     */
    private static boolean isServed(Registry registry) throws RemoteException {
        try {
            if (registry.lookup(NAME) instanceof RemoteObjectInvocationHandler handler) {
                return answers(handler);
            }
        } catch (NotBoundException e) {
            return false;
        } catch (UnmarshalException e) {
            // an object of another program
        }
        return false;
    }

    private static boolean answers(RemoteObjectInvocationHandler handler) {
        try {
            ((RemotePartition) Proxy.newProxyInstance(RemotePartition.class.getClassLoader(),
                    new Class<?>[] {RemotePartition.class}, handler)).greet();
            return true;
        } catch (RemoteException e) {
            return false;
        }
    }

    private static PartitionPort export(ServedPartition served, Registry registry, boolean own, int port,
                                        Consumer<String> log) throws IOException {
        Remote stub = UnicastRemoteObject.exportObject(served, port, null, null, SerialFilters::ofHost);
        RemoteObjectInvocationHandler handler = (RemoteObjectInvocationHandler) Proxy.getInvocationHandler(stub);
        registry.rebind(NAME, handler);
        return new PartitionPort(served, registry, own, handler, log);
    }

    /** Where the partition listens: the registry's port, or another one beside a registry that was there before. */
    public int port() {
        return port;
    }

    private static void everyTime(Runnable look) {
        try {
            while (true) {
                TimeUnit.SECONDS.sleep(LOOK_SECONDS);
                look.run();
            }
        } catch (InterruptedException e) {
            // closed
        }
    }

    private void expire() {
        served.expire();
    }

    /**
     * Binds the name again where it no longer leads here: any process of this machine may unbind it in a registry that
     * is another program, and that program may be started anew. A partition that serves under the name stays there.
     */
    private void keepBound() {
        String before = trouble;
        try {
            if (isBound()) {
                trouble = null;
            } else if (!ownRegistry && isServed(registry)) {
                trouble = "the registry leads masters to another PartitionServer";
            } else {
                registry.rebind(NAME, bound);
                trouble = null;
                log.accept("the registry had lost the name " + NAME + ", which is bound again");
            }
        } catch (RemoteException e) {
            trouble = "the registry does not answer: masters cannot find this PartitionServer";
        }
        if (trouble != null && !trouble.equals(before)) {
            log.accept(trouble);
        }
    }

    private boolean isBound() throws RemoteException {
        try {
            return registry.lookup(NAME).equals(bound);
        } catch (NotBoundException | UnmarshalException e) {
            return false;
        }
    }

    @Override
    public void close() throws RemoteException {
        look.interrupt();
        registryLook.interrupt();
        try {
            registryLook.join(TimeUnit.SECONDS.toMillis(LOOK_SECONDS));
            registry.unbind(NAME);
        } catch (NotBoundException | RemoteException e) {
            // it is gone already
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
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
