package radiosity.master.host;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import radiosity.rmi.RemotePartition;

/** The connection to a host, which exists before and after a partition answers there. */
public interface Link {

    /** The name by which the user calls the host. */
    String name();

    /** Looks up the partition on the host; fails after a few seconds where there is no answer. */
    RemotePartition connect() throws IOException;

    /** Begins calls to the host on another thread. */
    default <T> FutureTask<T> begin(Callable<T> calls) {
        return Host.start(calls);
    }

    /** Closes all connections, which ends calls that wait for an answer. */
    void cut();
}
