package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.net.InetAddress;
import java.net.UnknownHostException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a server prints for the user to type on another machine. */
class PartitionServerTest {

    @ParameterizedTest
    @ValueSource(strings = {"0.0.0.0", "::"})
    void serverOnAllAddresses_isCalledByItsName(String all) throws UnknownHostException {
        assertEquals(PartitionServer.name(null), PartitionServer.name(InetAddress.getByName(all)));
    }

    @Test
    void serverOnOneAddress_isCalledByIt() throws UnknownHostException {
        assertEquals("127.0.0.1", PartitionServer.name(InetAddress.getByName("127.0.0.1")));
    }

    @Test
    void machineWithoutAName_isCalledByAnAddressInANetwork() throws UnknownHostException {
        InetAddress address = InetAddress.getByName(PartitionServer.address());
        assertFalse(address.isAnyLocalAddress());
    }
}
