package radiosity.rmi;

import java.rmi.RemoteException;

/** A session is over: its master was silent for too long, or the host was started anew. */
public final class SessionEndedException extends RemoteException {

    private static final long serialVersionUID = 1;

    static final String WORDS = "the session has ended there";

    public SessionEndedException() {
        super(WORDS);
    }
}
