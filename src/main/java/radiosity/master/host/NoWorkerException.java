package radiosity.master.host;

import java.io.IOException;

/** None of the hosts that the user has named can be used. */
public final class NoWorkerException extends IOException {

    private static final long serialVersionUID = 1;

    public NoWorkerException(String message) {
        super(message);
    }
}
