package radiosity.master.host;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import radiosity.rmi.RemotePartition;

/** The way to a host, before and after somebody answers there. */
public interface Link {

    /** As the user calls the host. */
    String name();

    /** Looks the host up; fails in a few seconds where nobody answers. */
    RemotePartition connect() throws IOException;

    /** Begins calls to the host, which wait for what it answers. */
    default <T> FutureTask<T> begin(Callable<T> calls) {
        return Host.start(calls);
    }

    /** Ends all connections, also those on which an answer is waited for. */
    void cut();
}
