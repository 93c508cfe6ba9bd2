package radiosity.rmi;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.server.RMISocketFactory;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import javax.net.ssl.SSLServerSocket;
import javax.net.ssl.SSLSocket;

/**
 * The factory of the sockets of all remote calls of this process. Any thread may use it.
 *
 * <p>Connecting fails fast. All sockets to a host can be closed, which ends the calls that wait for this host. With a
 * key both ends must prove that they have the key. The JDK allows one such factory per process, which is set once; a
 * factory inside a stub would have to be known to every registry.
 */
public final class RmiSockets extends RMISocketFactory {

    private static final int CONNECT_MILLISECONDS = 2000;
    /** Longest wait for the answer to a handshake: a stopped process still accepts connections. */
    private static final int HANDSHAKE_MILLISECONDS = 3000;
    /** Time after which idle connections are closed: longer than the time between two rounds. */
    private static final int IDLE_MILLISECONDS = 600_000;
    private static final RmiSockets ALL = new RmiSockets();

    private final Map<HostAddress, Set<Socket>> open = new ConcurrentHashMap<>();
    private final Map<HostAddress, HostKey> keys = new ConcurrentHashMap<>();
    private final Map<Integer, Listening> listening = new ConcurrentHashMap<>();

    /**
     * The way of listening on a port.
     *
     * @param address address of this machine; null for all its addresses
     * @param key     key that callers must have; null for no key
     */
    private record Listening(InetAddress address, HostKey key) { }

    private RmiSockets() { }

    /** The factory, which RMI uses from now on. */
    public static synchronized RmiSockets inUse() throws IOException {
        if (RMISocketFactory.getSocketFactory() != ALL) {
            System.setProperty("sun.rmi.transport.tcp.handshakeTimeout", "" + HANDSHAKE_MILLISECONDS);
            System.setProperty("sun.rmi.transport.connectionTimeout", "" + IDLE_MILLISECONDS);
            RMISocketFactory.setSocketFactory(ALL);
        }
        return ALL;
    }

    /** Uses this key, or none where it is null, for connections to a host from now on. */
    public void use(HostAddress address, HostKey key) {
        if (key == null) {
            keys.remove(address);
        } else {
            keys.put(address, key);
        }
    }

    /** Sets how server sockets that are created from now on listen on a port, see {@link Listening}. */
    public void listen(int port, InetAddress address, HostKey key) {
        listening.put(port, new Listening(address, key));
    }

    @Override
    public Socket createSocket(String host, int port) throws IOException {
        HostAddress address = new HostAddress(host, port);
        HostKey key = keys.get(address);
        Socket socket = key == null ? new Socket() : key.context().getSocketFactory().createSocket();
        try {
            socket.connect(new InetSocketAddress(host, port), CONNECT_MILLISECONDS);
            socket.setTcpNoDelay(true);
            socket.setKeepAlive(true);
            if (socket instanceof SSLSocket secure) {
                secure.setSoTimeout(HANDSHAKE_MILLISECONDS);
                secure.startHandshake();
                secure.setSoTimeout(0);
            }
        } catch (IOException e) {
            socket.close();
            throw e;
        }
        add(address, socket);
        return socket;
    }

    /** Keeps a socket until {@link #cut}: a cut at the same time closes the socket, or leaves it to the next cut. */
    void add(HostAddress address, Socket socket) {
        open.compute(address, (a, known) -> {
            Set<Socket> sockets = known == null ? ConcurrentHashMap.newKeySet() : known;
            sockets.removeIf(Socket::isClosed);
            sockets.add(socket);
            return sockets;
        });
    }

    @Override
    public ServerSocket createServerSocket(int port) throws IOException {
        Listening how = listening.get(port);
        if (how == null) {
            return new ServerSocket(port);
        }
        if (how.key() == null) {
            return new OriginHidingServerSocket(port, how.address());
        }
        SSLServerSocket socket = (SSLServerSocket) how.key().context().getServerSocketFactory()
                .createServerSocket(port, 0, how.address());
        socket.setNeedClientAuth(true);
        return socket;
    }

    /**
     * Accepts connections and hides their origin. The JDK's registry lets callers from an address of this machine bind
     * and unbind names; callers of unknown origin may only look names up. Used without a key only: with a key, callers
     * without the key get no connection.
     */
    private static final class OriginHidingServerSocket extends ServerSocket {

        OriginHidingServerSocket(int port, InetAddress address) throws IOException {
            super(port, 0, address);
        }

        @Override
        public Socket accept() throws IOException {
            Socket accepted = new Socket() {
                @Override
                public InetAddress getInetAddress() {
                    return null;
                }
            };
            implAccept(accepted);
            return accepted;
        }
    }

    /** Closes all sockets to a host. The next call closes sockets that are connected meanwhile. */
    public void cut(HostAddress address) {
        Set<Socket> removed = open.remove(address);
        for (Socket socket : removed == null ? Set.<Socket>of() : removed) {
            try {
                socket.close();
            } catch (IOException e) {
                // a socket that fails to close cannot be used either
            }
        }
    }
}
