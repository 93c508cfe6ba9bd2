package radiosity.master.host;

import java.io.IOException;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.FutureTask;
import radiosity.rmi.HostLostException;

/** Makes calls on several hosts at once, and remembers which hosts were lost in them. */
public final class HostCalls {

    private final Map<Host, HostLostException> lost = new LinkedHashMap<>();

    /** A call on one host. */
    public interface Call<T> {
        T on(Host host) throws IOException;
    }

    /** Makes a call on several hosts; gives the results of the hosts that answer. The other hosts are lost. */
    public <T> Map<Host, T> onAll(Collection<Host> called, Call<T> call) {
        return await(start(called, call));
    }

    <T> Map<Host, FutureTask<T>> start(Collection<Host> called, Call<T> call) {
        Map<Host, FutureTask<T>> running = new LinkedHashMap<>();
        called.forEach(host -> running.put(host, host.begin(() -> call.on(host))));
        return running;
    }

    /**
     * Waits for a call that was started on several hosts. A host that is lost already is not awaited: hosts do rounds
     * in their order, so a host that an earlier round never reached would not come to this one.
     *
     * @return the results of the hosts that answer; the other hosts are lost
     */
    public <T> Map<Host, T> await(Map<Host, FutureTask<T>> running) {
        Map<Host, T> results = new LinkedHashMap<>();
        running.forEach((host, task) -> {
            try {
                if (!lost.containsKey(host)) {
                    results.put(host, host.await(task));
                }
            } catch (HostLostException e) {
                lost.put(host, e);
            }
        });
        return results;
    }

    /** Ends the sessions of several hosts at the same time; a session that cannot be ended runs out on its host. */
    public static void close(Collection<Host> hosts) {
        CompletableFuture.allOf(hosts.stream().map(host -> CompletableFuture.runAsync(host::close, Host.CALLS))
                .toArray(CompletableFuture<?>[]::new)).handle((done, failure) -> done).join();
    }

    /** Whether hosts were lost since {@link #takeLost} was called last. */
    public boolean isAnyLost() {
        return !lost.isEmpty();
    }

    /** The hosts that were lost since the last call of this method, with the reasons. */
    public Map<Host, HostLostException> takeLost() {
        Map<Host, HostLostException> taken = new LinkedHashMap<>(lost);
        lost.clear();
        return taken;
    }
}
