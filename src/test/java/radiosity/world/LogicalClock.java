package radiosity.world;

import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * What many hosts would need, from hosts in this process that compute one after the other: calls that are made on all
 * hosts at once take as long as the slowest one's processor time, and what a call costs on a network.
 *
 * <p>Counted is every call: rounds, blocks that move, checkpoints.
 */
final class LogicalClock {

    /** Two round trips of 0.2 ms and 0.3 ms for a call to all, and 30 us of the master per host. */
    private static final double CALL_SECONDS = 0.3e-3 + 2 * 0.2e-3;
    private static final double HOST_SECONDS = 30e-6;
    /** A gigabit per second, through the master's one port. */
    private static final double BYTES_PER_SECOND = 117e6;

    private final Map<String, Double> phase = new HashMap<>();
    private String phaseName = "";
    private long phaseBytes;
    private double slowest;
    private double network;
    private double cpu;
    private int calls;

    /** So many hosts on this clock. */
    List<Link> links(int hosts) {
        List<Link> links = TestLink.sound(hosts, 1);
        for (Link link : links) {
            put((TestLink) link, 1);
        }
        return links;
    }

    /** @param times how many times as slow the host is as this machine */
    TestLink put(TestLink link, double times) {
        RemotePartition behind = link.behind;
        InvocationHandler handler = (proxy, method, arguments) -> call(link.name(), times, behind, method, arguments);
        link.behind = (RemotePartition) Proxy.newProxyInstance(Link.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, handler);
        return link;
    }

    private Object call(String host, double times, RemotePartition behind, Method method, Object[] arguments) throws Throwable {
        if (method.getName().equals("ping")) {
            return method.invoke(behind, arguments);
        }
        synchronized (this) {
            long begin = BlockCosts.now();
            Object result;
            try {
                result = method.invoke(behind, arguments);
            } catch (InvocationTargetException e) {
                throw e.getCause();
            }
            double seconds = times * (BlockCosts.now() - begin) * 1e-9;
            count(host, name(method, arguments), seconds, bytes(arguments) + bytes(new Object[] {result}));
            return method.getName().equals("round") ? onIdleMachine((byte[]) result, times) : result;
        }
    }

    /** A part of a message belongs to the call that it is for. */
    private String name(Method method, Object[] arguments) {
        return switch (method.getName()) {
            case "send" -> "take";
            case "round" -> "round " + arguments[1];
            default -> method.getName();
        };
    }

    private static long bytes(Object[] values) {
        long bytes = 0;
        for (Object value : values == null ? new Object[0] : values) {
            bytes += value instanceof byte[] array ? array.length : 0;
        }
        return bytes;
    }

    private void count(String host, String name, double seconds, long bytes) {
        if (!name.equals(phaseName)) {
            end();
            phaseName = name;
        }
        phase.merge(host, seconds, Double::sum);
        phaseBytes += bytes;
        cpu += seconds;
    }

    private void end() {
        if (phase.isEmpty()) {
            return;
        }
        double most = phase.values().stream().mapToDouble(Double::doubleValue).max().orElse(0);
        slowest += most;
        network += CALL_SECONDS + phase.size() * HOST_SECONDS + phaseBytes / BYTES_PER_SECOND;
        calls++;
        phase.clear();
        phaseBytes = 0;
    }

    /** Wall time as it would be if nobody else were at work there. */
    private static byte[] onIdleMachine(byte[] bytes, double times) throws IOException {
        Reply reply = Reply.decode(bytes);
        return new Reply(reply.answer(), reply.cpu(), times * reply.cpu(), reply.work()).encode();
    }

    /** Begins to count. */
    synchronized void reset() {
        end();
        slowest = network = cpu = 0;
        calls = 0;
    }

    /** Calls to all so far. */
    synchronized int calls() {
        end();
        return calls;
    }

    /** Processor time of the slowest host in each call, s. */
    synchronized double slowest() {
        end();
        return slowest;
    }

    /** Processor time of all hosts, s. */
    double cpu() {
        return cpu;
    }

    /** What calls cost beside the hosts' computing, s. */
    synchronized double network() {
        end();
        return network;
    }
}
