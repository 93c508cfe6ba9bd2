package radiosity.rmi;

import java.io.IOException;

/** The master can no longer use a host. */
public final class HostLostException extends IOException {

    private static final long serialVersionUID = 1;

    /** Whether the host's computation has failed, not the connection to the host. */
    private final boolean computation;

    public HostLostException(String why, boolean computation, Throwable cause) {
        super(why, cause);
        this.computation = computation;
    }

    public boolean inComputation() {
        return computation;
    }
}
