package radiosity.rmi;

import java.rmi.RemoteException;

/** A session has ended, as its master was silent for too long, or another session has begun. */
public final class SessionEndedException extends RemoteException {

    private static final long serialVersionUID = 1;

    static final String WORDS = "the session has ended there";

    public SessionEndedException() {
        super(WORDS);
    }
}
