package radiosity.testkit;

import java.rmi.ConnectException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntPredicate;
import radiosity.master.host.Link;
import radiosity.rmi.RemotePartition;
import radiosity.worker.ServedPartition;

/** A host in this process that may die in a call, and come back. */
public final class TestLink implements Link {

    private final String name;
    private final int threads;
    /** Whether it dies in its n-th round. */
    private final IntPredicate dies;
    private final AtomicInteger rounds = new AtomicInteger();
    private volatile boolean dead;
    public volatile RemotePartition behind;
    /** Number of the round that never reaches it. */
    public volatile long unreached;
    /** That of the master and all hosts; null where each has its own. */
    LogicalClock clock;

    public TestLink(String name, int threads, IntPredicate dies) {
        this.name = name;
        this.threads = threads;
        this.dies = dies;
        behind = new ServedPartition(threads, line -> { });
    }

    public static List<Link> sound(int hosts, int threads) {
        List<Link> links = new ArrayList<>();
        for (int h = 0; h < hosts; h++) {
            links.add(new TestLink("host" + h, threads, round -> false));
        }
        return links;
    }

    /** A new process in its place. */
    public void revive() {
        behind = new ServedPartition(threads, line -> { });
        dead = false;
    }

    public boolean isDead() {
        return dead;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public RemotePartition connect() throws ConnectException {
        check();
        return (RemotePartition) java.lang.reflect.Proxy.newProxyInstance(getClass().getClassLoader(),
                new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> {
                    check();
                    checkReached(method.getName(), arguments);
                    try {
                        Object result = method.invoke(behind, arguments);
                        if (method.getName().equals("round") && dies.test(rounds.incrementAndGet())) {
                            dead = true;
                        }
                        check();
                        return result;
                    } catch (java.lang.reflect.InvocationTargetException e) {
                        throw e.getCause();
                    }
                });
    }

    private void checkReached(String method, Object[] arguments) throws ConnectException {
        if (method.equals("round") && (long) arguments[1] == unreached) {
            throw new ConnectException("round " + unreached);
        }
    }

    private void check() throws ConnectException {
        if (dead) {
            throw new ConnectException("dead");
        }
    }

    @Override
    public <T> FutureTask<T> begin(Callable<T> calls) {
        return clock == null ? Link.super.begin(calls) : clock.begin(calls);
    }

    @Override
    public void cut() { }
}
