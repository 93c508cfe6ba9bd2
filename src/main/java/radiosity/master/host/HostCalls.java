package radiosity.master.host;

import java.io.IOException;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import radiosity.rmi.HostLostException;

/** Calls on several hosts at once, and who did not answer. */
public final class HostCalls {

    private final Map<Host, HostLostException> lost = new LinkedHashMap<>();

    /** A call on one host. */
    public interface Call<T> {
        T on(Host host) throws IOException;
    }

    /** What each answers; who does not is lost. */
    public <T> Map<Host, T> onAll(Collection<Host> called, Call<T> call) {
        return await(start(called, call));
    }

    <T> Map<Host, FutureTask<T>> start(Collection<Host> called, Call<T> call) {
        Map<Host, FutureTask<T>> running = new LinkedHashMap<>();
        called.forEach(host -> running.put(host, host.begin(() -> call.on(host))));
        return running;
    }

    /**
     * What each answers to a call that was started; who does not is lost. Nobody waits for who is lost already: a host
     * does rounds in their order, and would not come to this one if it is there and one before never reached it.
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

    /** Ends all sessions at once. */
    public static void close(Collection<Host> hosts) {
        hosts.stream().map(host -> Host.start(() -> {
            host.close();
            return null;
        })).toList().forEach(HostCalls::end);
    }

    private static void end(FutureTask<Object> closing) {
        try {
            closing.get();
        } catch (ExecutionException | InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    public boolean isAnyLost() {
        return !lost.isEmpty();
    }

    /** Who was lost since this was asked last, and why. */
    public Map<Host, HostLostException> takeLost() {
        Map<Host, HostLostException> taken = new LinkedHashMap<>(lost);
        lost.clear();
        return taken;
    }
}
