package radiosity.distributed;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/** Network namespaces on a switch of their own; what stands in here needs root on Linux. */
final class TestNetwork implements AutoCloseable {

    /** One of the networks that are for tests (RFC 2544). */
    private static final String SUBNET = "198.18." + ProcessHandle.current().pid() % 256 + ".";

    private static final AtomicInteger MADE = new AtomicInteger();

    /** Never the same twice, as what is removed is there for a moment more. */
    private final String name = "rad" + ProcessHandle.current().pid() % 100_000 + (char) ('a' + MADE.getAndIncrement());
    private final int hosts;

    TestNetwork(int hosts) throws IOException {
        this.hosts = hosts;
        try {
            make();
        } catch (IOException e) {
            close();
            throw e;
        }
    }

    private void make() throws IOException {
        ip("link add " + name + " type bridge");
        ip("addr add " + SUBNET + "1/24 dev " + name);
        ip("link set " + name + " up");
        for (int host = 0; host < hosts; host++) {
            ip("netns add " + space(host));
            ip("link add " + outside(host) + " type veth peer name inner netns " + space(host));
            ip("link set " + outside(host) + " master " + name + " up");
            ip("-n " + space(host) + " addr add " + address(host) + "/24 dev inner");
            ip("-n " + space(host) + " link set inner up");
            ip("-n " + space(host) + " link set lo up");
        }
    }

    /** Tries. */
    static boolean isPossible() {
        try (TestNetwork network = new TestNetwork(1)) {
            return network.hosts == 1;
        } catch (IOException e) {
            return false;
        }
    }

    private String space(int host) {
        return name + "-" + host;
    }

    private String outside(int host) {
        return name + "v" + host;
    }

    String address(int host) {
        return SUBNET + (10 + host);
    }

    /** What to write before a command that shall run on a host. */
    List<String> inside(int host) {
        return List.of("ip", "netns", "exec", space(host));
    }

    /** The host's link goes down. */
    void pull(int host) throws IOException {
        ip("link set " + outside(host) + " down");
    }

    /** The switch forgets the host: links stay up, and what is sent either way is lost. */
    void drop(int host) throws IOException {
        ip("link set " + outside(host) + " nomaster");
    }

    private static void ip(String arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of("ip"));
        command.addAll(Arrays.asList(arguments.split(" ")));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes());
        if (process.onExit().join().exitValue() != 0) {
            throw new IOException("ip " + arguments + ": " + said);
        }
    }

    /** Removes as much of it as there is. */
    @Override
    public void close() {
        for (int host = 0; host < hosts; host++) {
            remove("link del " + outside(host));
            remove("netns del " + space(host));
        }
        remove("link del " + name);
    }

    private static void remove(String arguments) {
        try {
            ip(arguments);
        } catch (IOException e) {
            // it was not made
        }
    }
}
