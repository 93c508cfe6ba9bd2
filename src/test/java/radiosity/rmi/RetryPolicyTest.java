package radiosity.rmi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.RemoteException;
import java.rmi.UnmarshalException;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import org.junit.jupiter.api.Test;

class RetryPolicyTest {

    /** @return at which attempt a call comes through that fails like this at first */
    private static int attempt(RemoteException... failures) throws IOException {
        Deque<RemoteException> left = new ArrayDeque<>(Arrays.asList(failures));
        return RetryPolicy.repeat(() -> {
            if (!left.isEmpty()) {
                throw left.remove();
            }
            return failures.length + 1;
        });
    }

    @Test
    void aConnectionThatBreaks_isMadeOnceMore() throws IOException {
        assertEquals(2, attempt(new UnmarshalException("")));
        assertThrows(UnmarshalException.class, () -> attempt(new UnmarshalException(""), new UnmarshalException("")));
    }

    @Test
    void noConnectionInTime_isTriedUntilThereIsOne() throws IOException {
        assertEquals(5, attempt(new UnmarshalException(""), new ConnectIOException(""), new ConnectIOException(""),
                new ConnectIOException("")));
    }

    @Test
    void nobodyThere_isNotTriedForLong() {
        assertThrows(ConnectException.class, () -> attempt(new ConnectException(""), new ConnectException("")));
    }

    @Test
    void interrupt_endsTheTries_andIsKeptForTheCaller() {
        Thread.currentThread().interrupt();
        assertThrows(ConnectIOException.class, () -> attempt(new UnmarshalException(""), new ConnectIOException("")));
        assertTrue(Thread.interrupted());
    }

    @Test
    void aSessionThatEnded_isNotRepeated() {
        assertThrows(SessionEndedException.class, () -> attempt(new SessionEndedException()));
    }
}
