package radiosity.testkit;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import radiosity.master.host.Link;
import radiosity.partition.BlockCosts;
import radiosity.protocol.Reply;
import radiosity.rmi.RemotePartition;
import radiosity.util.Pieces;

/**
 * A clock of many hosts of which each is alone on its machine, and of a master on another one, for hosts in this
 * process: a call is carried out as soon as it is begun, and what follows when is reckoned.
 *
 * <p>A host does one call after another, each as soon as it has come; it takes the processor time that it takes here.
 * Bytes go through the master's one port, one message after another. The master goes on while hosts compute, until it
 * waits for one of them. Every call counts: rounds, blocks that move, checkpoints.
 */
public final class LogicalClock {

    /**
     * There and back: two round trips of 0.2 ms, as RMI looks whether a connection is alive before it uses it, and 0.3
     * ms.
     */
    private static final double THERE = 1.5 * 0.2e-3 + 0.15e-3;
    private static final double BACK = 0.5 * 0.2e-3 + 0.15e-3;
    /** Of the master's processor, for each call. */
    private static final double CALL = 30e-6;
    /** A gigabit per second, in each direction. */
    private static final double BYTES_PER_SECOND = 117e6;
    /** A packet: does not wait behind long messages. */
    private static final int LITTLE = 1460;
    /** What was received so long ago is done with, s. */
    private static final double LONG_AGO = 10;

    /** Per host: until when it computes, s. */
    private final Map<String, Double> busy = new HashMap<>();
    private final Map<String, Double> cpu = new HashMap<>();
    /** Until when the master's port sends, s. */
    private double sends;
    /** What the master's port receives: when it is ready, in this order, and how long it takes; s. */
    private final TreeMap<Double, Double> receives = new TreeMap<>();
    /** What the master's time is ahead of its thread's processor time, s. */
    private double ahead;
    private double waited;
    /** What the call that is being made has answered so far. */
    private long down;
    private long bytes;
    private int calls;
    /** How far the call has come that is being made, s; NaN where none is. */
    private double place = Double.NaN;
    /** Processor time here when that was so. */
    private double placed;

    /** So many hosts on this clock. */
    public List<Link> links(int hosts) {
        List<Link> links = new ArrayList<>();
        for (int h = 0; h < hosts; h++) {
            links.add(link(new TestLink("host" + h, 1, round -> false), 1));
        }
        return links;
    }

    /** @param times how many times as slow the host is as this machine */
    public Link link(TestLink link, double times) {
        RemotePartition behind = link.behind;
        link.behind = (RemotePartition) Proxy.newProxyInstance(Link.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class},
                (proxy, method, arguments) -> call(link.name(), times, behind, method, arguments));
        link.clock = this;
        return link;
    }

    private static double thread() {
        return BlockCosts.now() * 1e-9;
    }

    /** Of the master, s. For its thread only. */
    public double seconds() {
        return thread() + ahead;
    }

    /** The same, ns. */
    public long now() {
        return (long) (seconds() * 1e9);
    }

    /*---- Calls ----*/

    /** Does what is asked for now; who waits for it waits until it is done by this clock. */
    <T> FutureTask<T> begin(Callable<T> work) {
        ahead += CALL;
        double begun = thread();
        place = seconds();
        placed = begun;
        FutureTask<T> task = new FutureTask<>(work);
        task.run();
        double ready = place + thread() - placed;
        if (down > LITTLE) {
            receives.merge(ready, down / BYTES_PER_SECOND, Double::sum);
        }
        down = 0;
        place = Double.NaN;
        ahead -= thread() - begun;
        return new FutureTask<>(() -> {
            double now = seconds();
            double begin = thread();
            double wait = Math.max(0, received(ready) - now);
            waited += wait;
            ahead += wait + begin - thread();
            return null;
        }) {
            @Override
            @SuppressWarnings("unchecked")
            public T get(long timeout, TimeUnit unit)
                    throws InterruptedException, java.util.concurrent.ExecutionException {
                run();
                return task.get();
            }
        };
    }

    /** When all is received that is ready by then, s. */
    private double received(double ready) {
        double end = 0;
        for (Map.Entry<Double, Double> one : receives.headMap(ready, true).entrySet()) {
            end = Math.max(end, one.getKey()) + one.getValue();
        }
        receives.headMap(ready - LONG_AGO).clear();
        return Math.max(end, ready);
    }

    private Object call(String host, double times, RemotePartition behind, Method method, Object[] arguments)
            throws Throwable {
        if (Double.isNaN(place) || method.getName().equals("ping")) {
            return invoke(behind, method, arguments);
        }
        double there = place + thread() - placed;
        double begin = thread();
        Object result = invoke(behind, method, arguments);
        double spent = times * (thread() - begin);
        if (method.getName().equals("round")) {
            result = onIdleMachine((byte[]) result, times);
            calls++;
        }
        place = answered(host, there, spent, size(arguments), size(new Object[] {result}));
        placed = thread();
        return result;
    }

    /** When the answer is ready to be received. */
    private double answered(String host, double asked, double spent, long up, long answer) {
        double sent = asked;
        if (up > LITTLE) {
            sends = Math.max(sends, asked) + up / BYTES_PER_SECOND;
            sent = sends;
        }
        double done = Math.max(sent + THERE, busy.getOrDefault(host, 0.0)) + spent;
        busy.put(host, done);
        cpu.merge(host, spent, Double::sum);
        bytes += up + answer;
        down += answer;
        return done + BACK;
    }

    private static Object invoke(RemotePartition behind, Method method, Object[] arguments) throws Throwable {
        try {
            return method.invoke(behind, arguments);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    private static long size(Object[] values) {
        long size = 0;
        for (Object value : values == null ? new Object[0] : values) {
            size += value instanceof byte[] array ? array.length
                    : value instanceof byte[][] pieces ? Pieces.length(List.of(pieces)) : 0;
        }
        return size;
    }

    /** Wall time as it would be if nobody else were at work there. */
    private static byte[] onIdleMachine(byte[] reply, double times) throws IOException {
        Reply here = Reply.decode(reply);
        return new Reply(here.answer(), here.cpu(), times * here.cpu(), here.work(), here.given()).encode();
    }

    /*---- What came of it ----*/

    /** Begins to count. */
    public void reset() {
        cpu.clear();
        waited = 0;
        bytes = 0;
        calls = 0;
    }

    /** Rounds and parts of rounds, of all hosts together. */
    public int calls() {
        return calls;
    }

    /** Processor time of all hosts, s. */
    public double cpu() {
        return cpu.values().stream().mapToDouble(Double::doubleValue).sum();
    }

    /** Processor time of the host that had most to do, s. */
    public double busiest() {
        return cpu.values().stream().mapToDouble(Double::doubleValue).max().orElse(0);
    }

    /** Of the one that had least, s. */
    public double idlest() {
        return cpu.values().stream().mapToDouble(Double::doubleValue).min().orElse(0);
    }

    /** How long the master waited, s. */
    public double waited() {
        return waited;
    }

    /** What went through the master's port. */
    public long bytes() {
        return bytes;
    }
}
