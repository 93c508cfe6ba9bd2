package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.output.file.AtomicFile;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;

/** What is no scene file, or a damaged one, is refused in one line. */
@Tag("slow")
class DamagedSceneFileTest extends WrittenScene {

    @Test
    void damagedState_isNoticed() throws IOException {
        Handmade made = Handmade.litRoom(Vec3.ZERO);
        made.state = "what resuming needs".getBytes(StandardCharsets.US_ASCII);
        write(made.solution());
        byte[] bytes = Files.readAllBytes(file);
        bytes[bytes.length - 4] ^= 1;
        Files.write(file, bytes);
        try (SceneFile scene = SceneFile.open(file)) {
            String message = assertThrows(SceneFormatException.class, scene::state).getMessage();
            assertTrue(message.startsWith(file + ", state: expected SHA-256 "), message);
        }
    }

    @Test
    void cutOffAnywhere_isRefusedInOneLine() throws IOException {
        write(Handmade.litRoom(Vec3.ZERO).solution());
        byte[] whole = Files.readAllBytes(file);
        for (int length = 0; length < whole.length; length += 1 + length / 7) {
            Files.write(file, Arrays.copyOf(whole, length));
            assertRefused();
        }
    }

    private String assertRefused() {
        SceneFormatException e = assertThrows(SceneFormatException.class, () -> {
            try (SceneFile scene = SceneFile.open(file)) {
                scene.solution();
                scene.state();
            }
        });
        assertTrue(e.getMessage().startsWith(file.toString()), e.getMessage());
        assertEquals(1, e.getMessage().lines().count());
        return e.getMessage();
    }

    @Test
    void damagedBytes_areRefusedInOneLineOrHarmless() throws IOException {
        write(Handmade.litRoom(Vec3.ZERO).solution());
        byte[] whole = Files.readAllBytes(file);
        int json = ByteBuffer.wrap(whole).order(ByteOrder.LITTLE_ENDIAN).getInt(12);
        Random random = new Random(3);
        for (int i = 0; i < 500; i++) {
            byte[] damaged = whole.clone();
            damaged[random.nextInt(20 + json)] = (byte) (i % 2 == 0 ? random.nextInt() : '0' + random.nextInt(10));
            Files.write(file, damaged);
            try (SceneFile scene = SceneFile.open(file)) {
                scene.extras();
                scene.solution();
                scene.state();
            } catch (SceneFormatException refused) {
                assertEquals(1, refused.getMessage().lines().count());
            }
        }
    }

    @Test
    void foreignFiles_areRefusedInOneLine() throws IOException {
        Files.writeString(file, "LWSC\n1\nThis is a LightWave scene, not ours.\n");
        assertEquals(file + ": expected a scene file that RadiosityRenderer wrote, got "
                + "a LightWave scene", assertRefused());
        writeGlb("{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{}]}");
        assertEquals(file + ": expected a scene file of this program, got another glTF file", assertRefused());
        writeGlb("[1,2");
        assertRefused();
        writeGlb("7");
        assertRefused();
    }

    @Test
    void newerVersion_isRefusedInOneLine() throws IOException {
        writeGlb("{\"asset\":{\"version\":\"2.0\",\"extras\":{\"radiosity\":{\"formatVersion\":2}}}}");
        assertEquals(file + ": expected scene file format 1 or older, got format 2, of a newer program",
                assertRefused());
    }

    @Test
    void nodesInACircle_areRefusedInOneLine() throws IOException {
        writeGlb("""
                {"asset":{"version":"2.0","extras":{"radiosity":{"formatVersion":1}}},"scene":0,"scenes":[{"nodes":[0]}],
                "nodes":[{"children":[1]},{"children":[2]},{"children":[1]}]}""");
        assertEquals(file + ", JSON /nodes/2/children: expected nodes that have one parent, got [1]", assertRefused());
    }

    private void writeGlb(String json) throws IOException {
        AtomicFile.write(file, channel -> GlbWriter.write(channel, json.getBytes(StandardCharsets.UTF_8), List.of()));
    }
}
