package radiosity.rmi;

import java.io.IOException;

/** A host can no longer be used. */
public final class HostLostException extends IOException {

    private static final long serialVersionUID = 1;

    /** Whether the host's computation failed, not the way there. */
    private final boolean computation;

    public HostLostException(String why, boolean computation, Throwable cause) {
        super(why, cause);
        this.computation = computation;
    }

    public boolean inComputation() {
        return computation;
    }
}
