package radiosity.rmi;

import java.io.IOException;
import java.rmi.ConnectIOException;
import java.rmi.RemoteException;
import java.rmi.ServerError;
import java.util.concurrent.Callable;

/** Repeats calls to a host that allow it: a host whose connection breaks need not be lost. */
public final class RetryPolicy {

    /** Silence after which the master considers a host lost, s. */
    public static final double LOST_SECONDS = 10;
    /** Time for which connecting is retried, s: a host that is silent meanwhile is lost for its silence. */
    private static final double SECONDS = 1.5 * LOST_SECONDS;
    private static final long PAUSE_MILLISECONDS = 100;

    private RetryPolicy() { }

    /** Makes a call, and once more where its connection broke: as soon as the host can be connected to again. */
    public static <T> T repeat(Callable<T> call) throws IOException {
        try {
            return once(call);
        } catch (RemoteException e) {
            if (e instanceof ServerError || HostFailure.cause(e) instanceof SessionEndedException) {
                throw e;
            }
            return onceConnected(call);
        }
    }

    private static <T> T onceConnected(Callable<T> call) throws IOException {
        long begin = System.nanoTime();
        while (true) {
            try {
                return once(call);
            } catch (ConnectIOException e) {
                if ((System.nanoTime() - begin) * 1e-9 > SECONDS) {
                    throw e;
                }
                pause(e);
            }
        }
    }

    private static void pause(ConnectIOException failure) throws ConnectIOException {
        try {
            Thread.sleep(PAUSE_MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw failure;
        }
    }

    private static <T> T once(Callable<T> call) throws IOException {
        try {
            return call.call();
        } catch (IOException | RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }
}
