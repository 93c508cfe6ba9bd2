package radiosity.world;

import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.rmi.ServerError;

/** Why a host is lost, in words. */
final class Lost {

    private Lost() { }

    static HostLostException because(Throwable error) {
        if (error instanceof SessionEndedException) {
            return new HostLostException(error.getMessage(), false, error);
        }
        if (error instanceof ServerError && error.getCause() instanceof OutOfMemoryError) {
            return new HostLostException("out of memory there: give it JAVA_OPTS=-Xmx with more", true, error);
        }
        if (error instanceof ServerError || !(error instanceof RemoteException)) {
            return new HostLostException("error there: " + error, true, error);
        }
        String why = error instanceof ConnectException ? "no connection" : "connection closed";
        return new HostLostException(why, false, error);
    }
}
