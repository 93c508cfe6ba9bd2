package radiosity.cli;

import java.io.IOException;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.rmi.server.ExportException;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Comparator;
import java.util.concurrent.CountDownLatch;
import radiosity.cli.options.CommandRun;
import radiosity.cli.options.Failure;
import radiosity.cli.options.ServerOptions;
import radiosity.cli.render.FileChecks;
import radiosity.rmi.HostAddress;
import radiosity.rmi.HostKey;
import radiosity.worker.PartitionPort;

/** Program that computes a part of a scene for a RadiosityRenderer (section 4.5.6 and appendix C.3 of the paper). */
public final class PartitionServer {

    private static final DateTimeFormatter SECONDS = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss");

    private final ServerOptions options;

    private PartitionServer(ServerOptions options) {
        this.options = options;
    }

    public static void main(String[] arguments) {
        System.exit(run(arguments));
    }

    /**
     * Runs the program without ending the process; returns only after {@code --help}, {@code --version} or an error.
     *
     * @return the exit code
     */
    static int run(String... arguments) {
        ServerOptions options = new ServerOptions();
        return CommandRun.of(options, options.common, new PartitionServer(options)::serve, arguments);
    }

    private void serve() throws IOException {
        if (options.host != null) {
            System.setProperty("java.rmi.server.hostname", options.host);
        }
        InetAddress bind = bind();
        HostKey key = options.key == null ? null : FileChecks.key(options.key);
        int second = options.secondPort == null ? 0 : options.secondPort;
        PartitionPort port = open(new PartitionPort.Options(options.port, second, bind, key, options.threads));
        print(listening(port.port(), bind, key));
        Runtime.getRuntime().addShutdownHook(new Thread(() -> print("ended")));
        forEver();
    }

    private static PartitionPort open(PartitionPort.Options options) throws IOException {
        try {
            return PartitionPort.open(options, PartitionServer::print);
        } catch (PartitionPort.KeyBehindRegistryException e) {
            throw Failure.failed("-key", "expected a port without an rmiregistry, got " + options.registryPort()
                    + ", where one runs");
        } catch (ExportException e) {
            throw Failure.failed("-port", "expected a port that is free or an rmiregistry's, got "
                    + options.registryPort() + ", which is taken");
        }
    }

    private String listening(int port, InetAddress bind, HostKey key) {
        String ports = port == options.port ? "port " + port
                : "ports " + options.port + " (the rmiregistry that was running) and " + port;
        HostAddress address = new HostAddress(options.host != null ? options.host : name(bind), options.port);
        return "listening on " + ports + (bind == null ? "" : " of " + bind.getHostAddress())
                + (key == null ? "" : " with a key") + ", " + options.threads
                + (options.threads == 1 ? " thread" : " threads") + "; render with: RadiosityRenderer -h 1 " + address
                + (key == null ? "" : " -key " + options.key) + " foobar.lws foobar.scene";
    }

    /** The name or address by which others reach this machine, where the user gives no name. */
    static String name(InetAddress bind) {
        if (bind != null && !bind.isAnyLocalAddress()) {
            return bind.getHostAddress();
        }
        try {
            return InetAddress.getLocalHost().getHostName();
        } catch (UnknownHostException e) {
            return address();
        }
    }

    /** An address of this machine in a network, the first of those of version 4 if there are any; or localhost. */
    static String address() {
        try {
            return NetworkInterface.networkInterfaces().flatMap(NetworkInterface::inetAddresses)
                    .filter(address -> !address.isLoopbackAddress() && !address.isLinkLocalAddress())
                    .min(Comparator.comparing(address -> address.getAddress().length))
                    .map(InetAddress::getHostAddress).orElse("localhost");
        } catch (SocketException e) {
            return "localhost";
        }
    }

    private InetAddress bind() throws IOException {
        try {
            InetAddress bind = options.bind == null ? null : InetAddress.getByName(options.bind);
            if (bind != null && !bind.isAnyLocalAddress() && NetworkInterface.getByInetAddress(bind) == null) {
                throw new UnknownHostException();
            }
            return bind;
        } catch (UnknownHostException e) {
            throw Failure.commandLine("-bind", "expected an address of this machine, got " + options.bind);
        }
    }

    private static void print(String line) {
        System.out.println(LocalDateTime.now().format(SECONDS) + " " + line);
    }

    private static void forEver() {
        try {
            new CountDownLatch(1).await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
