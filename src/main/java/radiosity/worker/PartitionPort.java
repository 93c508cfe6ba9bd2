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
 * The port on which a host serves masters (section 4.5.6 of the paper): a registry and a partition on one port.
 *
 * <p>If the port belongs to an {@code rmiregistry} that runs already, as in appendix C.3 of the paper, that registry is
 * used, and the partition has a port of its own. The registry holds the bare handler of the stub, a class of the JDK,
 * as a registry that was started elsewhere does not know {@link RemotePartition}.
 */
public final class PartitionPort implements AutoCloseable {

    /** Name of the partition in the registry. */
    public static final String NAME = "Partition";
    private static final String HERE = "localhost";
    private static final int LOOK_SECONDS = 2;

    /** The port with a key belongs to an {@code rmiregistry}: it has no key, so that masters with one cannot ask it. */
    public static final class KeyBehindRegistryException extends ExportException {
        private static final long serialVersionUID = 1;

        KeyBehindRegistryException() {
            super("a registry without a key has the port");
        }
    }

    /** Referred to from here, as the object would else be collected as garbage. */
    private final ServedPartition served;
    private final Registry registry;
    private final boolean ownRegistry;
    /** The object that is bound to {@link #NAME} in the registry. */
    private final RemoteObjectInvocationHandler bound;
    private final int port;
    private final Consumer<String> log;
    /** What was wrong at the last look at the registry; null where masters find this partition there. */
    private String trouble;
    private final Thread look = new Thread(() -> everyTime(this::expire), "gone masters");
    /** Looks at the registry; a thread of its own, as a registry in another program may keep the thread waiting. */
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
     * The settings of a host.
     *
     * @param registryPort   port of the registry, on which masters look for the partition
     * @param partitionPort  port of the partition where the registry is another program; 0 for any free port
     * @param bind           address on which to listen; null for all addresses of this machine
     * @param key            key that masters must have; null for no key
     * @param threads        number of threads with which the host computes
     */
    public record Options(int registryPort, int partitionPort, InetAddress bind, HostKey key, int threads) { }

    /**
     * Begins to serve masters.
     *
     * @param log receives one line for each master that comes or goes
     * @throws KeyBehindRegistryException where there is a key, and the port belongs to a registry without one
     * @throws RemoteException where a port is in use by another program, or cannot be opened
     */
    public static PartitionPort open(Options options, Consumer<String> log) throws IOException {
        RmiSockets sockets = RmiSockets.inUse();
        sockets.listen(options.registryPort(), options.bind(), options.key());
        ServedPartition served = new ServedPartition(options.threads(), log);
        Registry own;
        try {
            own = LocateRegistry.createRegistry(options.registryPort());
        } catch (ExportException e) {
            return behind(options, sockets, served, e, log);
        }
        return export(served, own, true, options.registryPort(), log);
    }

    /** Serves behind the registry that has the port; throws {@code taken} where none answers or a server is bound. */
    private static PartitionPort behind(Options options, RmiSockets sockets, ServedPartition served,
                                        ExportException taken, Consumer<String> log) throws IOException {
        SerialFilters.ofMaster();
        Registry other = LocateRegistry.getRegistry(HERE, options.registryPort());
        try {
            if (isServed(other)) {
                throw taken;
            }
            if (options.key() != null) {
                throw new KeyBehindRegistryException();
            }
            sockets.listen(options.partitionPort(), options.bind(), options.key());
            return export(served, other, false, options.partitionPort(), log);
        } catch (RemoteException e) {
            if (e instanceof ExportException) {
                throw e;
            }
            throw taken;
        }
    }

    /**
     * Whether {@link #NAME} in a registry leads to a partition that answers. An entry of a server that has ended may be
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
            // the name belongs to an object of another program
        }
        return false;
    }

    /** Asks at this machine first: the name in the stub is for others, and need not lead back from here. */
    private static boolean answers(RemoteObjectInvocationHandler handler) {
        try {
            HostStub.partition(HostStub.of(handler).at(HERE).handler()).greet();
            return true;
        } catch (IOException e) {
            return answersThere(handler);
        }
    }

    private static boolean answersThere(RemoteObjectInvocationHandler handler) {
        try {
            HostStub.partition(handler).greet();
            return true;
        } catch (RemoteException e) {
            return false;
        }
    }

    /** Exports and binds a partition; where that fails, neither partition nor own registry is exported any more. */
    static PartitionPort export(ServedPartition served, Registry registry, boolean own, int port,
                                Consumer<String> log) throws IOException {
        try {
            Remote stub = UnicastRemoteObject.exportObject(served, port, null, null, SerialFilters::ofHost);
            RemoteObjectInvocationHandler handler = (RemoteObjectInvocationHandler) Proxy.getInvocationHandler(stub);
            registry.rebind(NAME, handler);
            return new PartitionPort(served, registry, own, handler, log);
        } catch (IOException | RuntimeException | Error e) {
            unexport(served);
            if (own) {
                unexport(registry);
            }
            throw e;
        }
    }

    /** Port of the partition: the registry's, or another one where the registry is another program. */
    public int port() {
        return port;
    }

    private void everyTime(Runnable look) {
        try {
            while (true) {
                TimeUnit.SECONDS.sleep(LOOK_SECONDS);
                once(look, log);
            }
        } catch (InterruptedException e) {
            // this port was closed
        }
    }

    /** Looks once; a failure is logged, if it can be, and does not end the looks. */
    static void once(Runnable look, Consumer<String> log) {
        try {
            look.run();
        } catch (RuntimeException | OutOfMemoryError e) {
            try {
                log.accept("look after masters and registry: expected no error, got " + e);
            } catch (RuntimeException | OutOfMemoryError again) {
                // the log may be what has failed
            }
        }
    }

    private void expire() {
        served.expire();
    }

    /**
     * Binds the name again where the registry no longer has it: if the registry is another program, any process of this
     * machine may unbind names, and the registry may be restarted. Another partition that answers under the name stays.
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
            // the registry or the name is gone already
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        UnicastRemoteObject.unexportObject(served, true);
        if (ownRegistry) {
            unexport(registry);
        }
    }

    private static void unexport(Remote exported) {
        try {
            UnicastRemoteObject.unexportObject(exported, true);
        } catch (NoSuchObjectException e) {
            // was not exported, or is gone already
        }
    }
}
