package radiosity.rmi;

import java.io.IOException;
import java.io.InvalidClassException;
import java.io.ObjectStreamException;
import java.rmi.AccessException;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.MarshalException;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.ServerError;
import java.rmi.ServerException;
import java.rmi.UnknownHostException;
import java.rmi.UnmarshalException;
import radiosity.rmi.HostLostException.Failure;

/** Explains in plain words on one line why a host is lost or cannot be used; messages of RMI have several lines. */
public final class HostFailure {

    private static final int LONGEST_MESSAGE = 200;

    private HostFailure() { }

    /**
     * The exception with the reason for which a host is lost.
     *
     * @param error error that a call to the host has thrown
     * @throws OutOfMemoryError where this process lacks memory; lack of memory on the host comes in an exception of RMI
     */
    public static HostLostException because(Throwable error) {
        if (error instanceof OutOfMemoryError here) {
            throw here;
        }
        Throwable cause = cause(error);
        return new HostLostException(words(cause), failure(cause), error);
    }

    private static Failure failure(Throwable cause) {
        if (cause instanceof ServerError || !(cause instanceof RemoteException)) {
            return Failure.COMPUTATION;
        }
        return isRefusal(cause) ? Failure.MESSAGE : Failure.CONNECTION;
    }

    /** Whether a filter, see {@link SerialFilters}, has refused a message: a call on the host, or an answer here. */
    private static boolean isRefusal(Throwable cause) {
        return cause instanceof UnmarshalException && cause.getCause() instanceof InvalidClassException;
    }

    /** The cause of a failed call: where the host's side threw a remote exception, that exception, else the error. */
    static Throwable cause(Throwable error) {
        return error instanceof ServerException && error.getCause() instanceof RemoteException thrown ? cause(thrown)
                : error;
    }

    /** The reason, in words, of an error that was thrown by connecting to a host or by a call to the host. */
    public static String words(Throwable error) {
        Throwable cause = cause(error);
        if (cause instanceof ServerError) {
            return cause.getCause() instanceof OutOfMemoryError
                    ? "out of memory there: give it JAVA_OPTS=-Xmx with more" : internal(cause.getCause());
        }
        if (cause instanceof RemoteException remote) {
            return ofTheWay(remote);
        }
        return cause instanceof IOException && cause.getMessage() != null ? line(cause.getMessage()) : internal(cause);
    }

    /** The reason in words where the connection has failed. */
    private static String ofTheWay(RemoteException error) {
        if (error instanceof SessionEndedException) {
            return SessionEndedException.WORDS;
        }
        if (error instanceof ConnectException || error instanceof ConnectIOException) {
            return "no connection";
        }
        if (error instanceof UnknownHostException) {
            return "no machine of this name";
        }
        if (error instanceof NoSuchObjectException) {
            return "it was started anew";
        }
        if (error instanceof AccessException) {
            return "it refuses calls";
        }
        if (isRefusal(error)) {
            return "a message was refused for its size or kind: give both sides JAVA_OPTS=-Xmx with more";
        }
        boolean cut = error instanceof MarshalException || error instanceof UnmarshalException;
        return cut && error.getCause() instanceof IOException && !(error.getCause() instanceof ObjectStreamException)
                ? "connection closed" : "no sound answer";
    }

    /** @param error error on the host; null where the host sent none, as hosts are not trusted */
    private static String internal(Throwable error) {
        if (error == null) {
            return "internal error there";
        }
        String kind = error.getClass().getSimpleName();
        return "internal error there, " + kind + (error.getMessage() == null ? "" : ": " + line(error.getMessage()));
    }

    /** The first line of a message, which may come from a host, without characters that control a terminal. */
    private static String line(String message) {
        String first = message.strip().lines().findFirst().orElse("").replaceAll("\\p{Cntrl}", " ");
        return first.length() <= LONGEST_MESSAGE ? first : first.substring(0, LONGEST_MESSAGE) + "...";
    }
}
