package radiosity.rmi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class RmiSocketsTest {

    private static final HostAddress HOST = new HostAddress("igge", 1);

    @Test
    void socketThatIsConnectedDuringACut_isClosedByTheNext() throws IOException {
        RmiSockets sockets = RmiSockets.inUse();
        List<Socket> meanwhile = Stream.generate(Socket::new).limit(50).toList();
        sockets.add(HOST, new Socket() {
            @Override
            public void close() throws IOException {
                super.close();
                meanwhile.forEach(socket -> sockets.add(HOST, socket));
            }
        });
        sockets.cut(HOST);
        sockets.cut(HOST);
        assertEquals(List.of(), meanwhile.stream().filter(socket -> !socket.isClosed()).toList());
    }

    @Test
    void socketsToOtherHosts_stayOpen() throws IOException {
        RmiSockets sockets = RmiSockets.inUse();
        try (Socket cut = new Socket(); Socket other = new Socket()) {
            sockets.add(HOST, cut);
            sockets.add(new HostAddress("igge", 2), other);
            sockets.cut(HOST);
            assertTrue(cut.isClosed() && !other.isClosed());
        }
    }
}
