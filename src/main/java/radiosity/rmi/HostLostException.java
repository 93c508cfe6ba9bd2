package radiosity.rmi;

import java.io.IOException;

/** The master can no longer use a host. */
public final class HostLostException extends IOException {

    private static final long serialVersionUID = 1;

    /** What has failed. */
    public enum Failure {
        /** The connection, or the host's process: the host may come back. */
        CONNECTION,
        /** The host's computation, which may fail everywhere else, too. */
        COMPUTATION,
        /** A message was refused for its size or its kind, and would be refused again after the host's return. */
        MESSAGE
    }

    private final Failure failure;

    public HostLostException(String why, Failure failure, Throwable cause) {
        super(why, cause);
        this.failure = failure;
    }

    public Failure failure() {
        return failure;
    }
}
