package radiosity.master.host;

import java.io.IOException;
import java.io.NotSerializableException;
import java.net.UnknownHostException;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.NotBoundException;
import java.rmi.RemoteException;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.util.ArrayList;
import java.util.List;
import javax.net.ssl.SSLException;
import radiosity.rmi.HostAddress;
import radiosity.rmi.HostFailure;
import radiosity.rmi.HostKey;
import radiosity.rmi.HostStub;
import radiosity.rmi.RemotePartition;
import radiosity.rmi.RmiSockets;
import radiosity.rmi.SerialFilters;
import radiosity.worker.PartitionPort;

/** The connection to a host over RMI. */
public final class RmiLink implements Link {

    private final HostAddress address;
    private final HostKey key;
    private final RmiSockets sockets;
    /** Address of the partition: it has another port than the registry if that is a program of its own. */
    private volatile HostAddress partition;

    private RmiLink(HostAddress address, HostKey key, RmiSockets sockets) {
        this.address = address;
        this.key = key;
        this.sockets = sockets;
        partition = address;
    }

    /** A link to each address, with a key or null; sets the filter and the socket factory of this process. */
    public static List<Link> to(List<HostAddress> addresses, HostKey key) throws IOException {
        SerialFilters.ofMaster();
        RmiSockets sockets = RmiSockets.inUse();
        List<Link> links = new ArrayList<>();
        for (HostAddress address : addresses) {
            links.add(new RmiLink(address, key, sockets));
        }
        return links;
    }

    @Override
    public String name() {
        return address.toString();
    }

    @Override
    public RemotePartition connect() throws IOException {
        sockets.use(address, key);
        try {
            Registry registry = LocateRegistry.getRegistry(address.host(), address.port());
            if (!(registry.lookup(PartitionPort.NAME) instanceof RemoteObjectInvocationHandler handler)) {
                throw new IOException("no PartitionServer behind the registry there");
            }
            HostStub stub = HostStub.of(handler).at(address.host());
            partition = new HostAddress(address.host(), stub.port());
            sockets.use(partition, key);
            RemotePartition remote = HostStub.partition(stub.handler());
            if (!partition.equals(address)) {
                greet(remote);
            }
            return remote;
        } catch (NotBoundException | NotSerializableException e) {
            throw new IOException("no PartitionServer behind the registry on port " + address.port(), e);
        } catch (RemoteException e) {
            throw new IOException(why(e), e);
        }
    }

    /** Tries whether a partition answers that has another port than the registry, which a firewall may close. */
    private void greet(RemotePartition remote) throws IOException {
        try {
            remote.greet();
        } catch (ConnectException | ConnectIOException e) {
            throw new IOException("no answer on port " + partition.port() + ", which the registry on port "
                    + address.port() + " names", e);
        } catch (RemoteException e) {
            throw new IOException(HostFailure.words(e), e);
        }
    }

    private String why(RemoteException e) {
        Throwable cause = e.getCause();
        if (cause instanceof UnknownHostException || e instanceof java.rmi.UnknownHostException) {
            return "no machine of this name";
        }
        if (cause instanceof SSLException) {
            String said = String.valueOf(cause.getMessage());
            return said.contains("certi") || said.contains("PKIX") ? "it has another key (-key)"
                    : "it was started without a key (-key)";
        }
        if (String.valueOf(e.getMessage()).contains("non-JRMP") || cause instanceof java.io.EOFException) {
            return key == null ? "no PartitionServer on port " + address.port()
                    + ", or one that was started with a key (-key)"
                    : "it has another key (-key), or none";
        }
        String running = "(is PartitionServer running there?)";
        return e instanceof ConnectException || cause instanceof java.net.SocketTimeoutException
                ? "no answer on port " + address.port() + " " + running
                : "no sound answer on port " + address.port() + " " + running;
    }

    @Override
    public void cut() {
        sockets.cut(address);
        sockets.cut(partition);
    }
}
