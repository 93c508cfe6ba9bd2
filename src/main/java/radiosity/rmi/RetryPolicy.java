package radiosity.rmi;

import java.io.IOException;
import java.rmi.ConnectIOException;
import java.rmi.RemoteException;
import java.rmi.ServerError;
import java.util.concurrent.Callable;

/** How often a call to a host is made that may be repeated: a connection that breaks is no host that is lost. */
public final class RetryPolicy {

    /** Silence after which a host is lost, s. */
    public static final double LOST_SECONDS = 10;
    /** How long a connection is tried to be made: longer than a host may be silent, so that is what it is lost for. */
    private static final double SECONDS = 1.5 * LOST_SECONDS;
    private static final long PAUSE_MILLISECONDS = 100;

    private RetryPolicy() { }

    /** Repeats a call once where its connection broke, or as soon as one can be made again. */
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
