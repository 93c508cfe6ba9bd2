package radiosity.rmi;

import java.io.IOException;
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

/** Why a host is lost or cannot be used, in plain words on one line: what RMI says of it has several lines. */
public final class HostFailure {

    private static final int LONGEST_MESSAGE = 200;

    private HostFailure() { }

    /**
     * Why a host is lost.
     *
     * @param error what a call to the host has thrown
     * @throws OutOfMemoryError where it was thrown here: what a host lacks comes in an exception of RMI
     */
    public static HostLostException because(Throwable error) {
        if (error instanceof OutOfMemoryError here) {
            throw here;
        }
        Throwable cause = cause(error);
        boolean computation = cause instanceof ServerError || !(cause instanceof RemoteException);
        return new HostLostException(words(cause), computation, error);
    }

    /** What a call has failed with: where the host's side of it threw a remote exception, that one. */
    static Throwable cause(Throwable error) {
        return error instanceof ServerException && error.getCause() instanceof RemoteException thrown ? cause(thrown)
                : error;
    }

    /** @param error what connecting to a host or a call to it has thrown */
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
        boolean cut = error instanceof MarshalException || error instanceof UnmarshalException;
        return cut && error.getCause() instanceof IOException && !(error.getCause() instanceof ObjectStreamException)
                ? "connection closed" : "no sound answer";
    }

    /** @param error may be null: hosts are not trusted */
    private static String internal(Throwable error) {
        if (error == null) {
            return "internal error there";
        }
        String kind = error.getClass().getSimpleName();
        return "internal error there, " + kind + (error.getMessage() == null ? "" : ": " + line(error.getMessage()));
    }

    /** Messages may come from a host: their first line, without what would steer a terminal. */
    private static String line(String message) {
        String first = message.strip().lines().findFirst().orElse("").replaceAll("\\p{Cntrl}", " ");
        return first.length() <= LONGEST_MESSAGE ? first : first.substring(0, LONGEST_MESSAGE) + "...";
    }
}
