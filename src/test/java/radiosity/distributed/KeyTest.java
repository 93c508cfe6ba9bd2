package radiosity.distributed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.UnicastRemoteObject;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.master.host.NoWorkerException;
import radiosity.rmi.HostKey;
import radiosity.scene.SceneFormatException;
import radiosity.settings.Schedule;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.NeedsProgram;
import radiosity.worker.PartitionPort;

/** One key file on both sides, or one clear line. */
@Tag("slow")
@NeedsProgram("sh")
class KeyTest {

    @TempDir
    static Path directory;
    private static HostKey key;
    private static HostKey otherKey;

    private final List<String> notices = new CopyOnWriteArrayList<>();

    @BeforeAll
    static void makeKeys() throws Exception {
        key = make("a.key");
        otherKey = make("b.key");
    }

    private static HostKey make(String name) throws Exception {
        Path file = directory.resolve(name);
        ProcessBuilder script = new ProcessBuilder("scripts/make-key", file.toString()).redirectErrorStream(true);
        script.environment().put("JAVA_HOME", System.getProperty("java.home"));
        Process process = script.start();
        String said = new String(process.getInputStream().readAllBytes());
        assertEquals(0, process.waitFor(), said);
        return HostKey.read(file);
    }

    private void assertRefused(HostKey ofHost, HostKey ofMaster, String message) throws IOException {
        try (PartitionPort host = Small.serve(ofHost, 1)) {
            assertThrows(NoWorkerException.class, () -> Small.remote(Schedule.PAPER, ofMaster, notices::add, host));
        }
        assertEquals(1, notices.size());
        assertTrue(notices.get(0).contains(message), notices::toString);
    }

    @Test
    void sameKey_givesTheSameBits() throws IOException {
        try (PartitionPort host = Small.serve(key, 1)) {
            ColouredRoom.assertSame(Small.local(Schedule.PAPER), Small.remote(Schedule.PAPER, key, notices::add, host));
        }
        assertEquals(List.of(), notices);
    }

    @Test
    void masterWithoutKey_isRefused() throws IOException {
        assertRefused(key, null, "or one that was started with a key (-key)");
    }

    @Test
    void hostWithoutKey_isRefused() throws IOException {
        assertRefused(null, key, "without a key (-key)");
    }

    @Test
    void otherKey_isRefused() throws IOException {
        assertRefused(otherKey, key, "it has another key (-key)");
    }

    @Test
    void fileThatIsNoKey_isNamed() throws IOException {
        Path file = Files.writeString(directory.resolve("no.key"), "no key");
        assertTrue(assertThrows(SceneFormatException.class, () -> HostKey.read(file)).getMessage()
                .contains("no.key: expected a key that scripts/make-key has made"));
    }

    @Test
    void existingFile_isNotOverwritten() throws Exception {
        Path file = Files.writeString(directory.resolve("precious"), "mine");
        assertEquals(3, new ProcessBuilder("scripts/make-key", file.toString()).start().waitFor());
        assertEquals("mine", Files.readString(file));
    }

    /** A master with the key could not ask the registry, and one without it could not use the server. */
    @Test
    void serverWithAKey_isNotStartedBehindAnRmiregistry() throws Exception {
        int port = Small.freePort();
        Registry registry = LocateRegistry.createRegistry(port);
        try {
            Process server = Server.start("radiosity.cli.PartitionServer", "-port", "" + port, "-key",
                    directory.resolve("a.key").toString());
            String said = server.inputReader().readLine();
            server.destroyForcibly();
            assertEquals("-key: expected a port without an rmiregistry, got " + port + ", where one runs", said);
        } finally {
            UnicastRemoteObject.unexportObject(registry, true);
        }
    }
}
