package radiosity.solution;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.SameBitsTest;
import radiosity.testkit.ColouredRoom;

/** A state is its bytes, however they are cut into pieces, and however many there are. */
class SavedStateTest {

    private static byte[] random(int length) {
        byte[] bytes = new byte[length];
        new Random(length).nextBytes(bytes);
        return bytes;
    }

    private static byte[] written(SavedState state) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        state.writeTo(out);
        return out.toByteArray();
    }

    @Test
    void readInPieces_isTheSameBytesAndTheirHash() throws Exception {
        byte[] bytes = random(3_000_001);
        SavedState whole = SavedState.of(List.of(bytes));
        for (int most : new int[] {1000, 1_500_000, 3_000_001, 4_000_000}) {
            SavedState pieces = SavedState.read(new ByteArrayInputStream(bytes), bytes.length, most);
            assertEquals("state of 3000001 bytes in " + (3_000_001 + most - 1) / most + " pieces", pieces.toString());
            assertArrayEquals(bytes, written(pieces));
            assertArrayEquals(bytes, pieces.open().readAllBytes());
            assertEquals(whole, pieces);
            assertEquals(HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes)), pieces.sha256());
        }
        assertNotEquals(whole, SavedState.of(List.of(Arrays.copyOf(bytes, 3_000_000))));
    }

    /** The arrays are changed, against the rule, after the hash must have been computed. */
    @Test
    void hash_isComputedOnce_andWhileTheStateIsRead() throws Exception {
        byte[] bytes = random(1000);
        String expected = HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
        List<byte[]> read = new ArrayList<>();
        InputStream in = new ByteArrayInputStream(bytes) {
            @Override
            public int readNBytes(byte[] piece, int from, int most) {
                read.add(piece);
                return super.readNBytes(piece, from, most);
            }
        };
        SavedState fromFile = SavedState.read(in, bytes.length, 300);
        assertEquals(4, read.size());
        read.forEach(piece -> piece[0]++);
        assertEquals(expected, fromFile.sha256());

        SavedState made = SavedState.of(List.of(bytes));
        assertEquals(expected, made.sha256());
        bytes[0]++;
        assertEquals(expected, made.sha256());
    }

    @Test
    void inputThatEndsEarly_isRefused() {
        assertThrows(EOFException.class, () -> SavedState.read(new ByteArrayInputStream(new byte[100]), 101, 30));
    }

    /** Three gibibytes, of one array of 64 MiB that is there 48 times. */
    @Test
    void moreThanAnArrayHolds_isCountedAndReadToTheEnd() throws IOException {
        byte[] piece = random(1 << 26);
        SavedState state = SavedState.of(Collections.nCopies(48, piece));
        assertEquals(3L << 30, state.length());
        try (InputStream in = state.open()) {
            assertEquals(Integer.MAX_VALUE, in.available());
            in.skipNBytes((3L << 30) - 5);
            assertEquals(5, in.available());
            assertArrayEquals(Arrays.copyOfRange(piece, piece.length - 5, piece.length), in.readAllBytes());
            assertEquals(0, in.available());
        }
    }

    @Test
    void calculation_goesOnFromAStateInPieces() throws IOException {
        RadiositySettings settings = SameBitsTest.settings(Schedule.PREDICT);
        Solution atOnce = SameBitsTest.solve(new LocalWorld(ColouredRoom.SCENE, settings, 1), SameBitsTest.shots(40));
        SavedState half = SameBitsTest.solve(new LocalWorld(ColouredRoom.SCENE, settings, 1), SameBitsTest.shots(20))
                .state();
        assertTrue(half.toString().matches(".* in ([3-9]|\\d\\d+) pieces"), half + ": no array holds all blocks");
        ProgressiveRadiosity rest = new ProgressiveRadiosity(new LocalWorld(ColouredRoom.SCENE, settings, 1),
                SameBitsTest.shots(40));
        rest.resume(SavedState.read(half.open(), half.length(), 37));
        rest.run(progress -> true);
        assertSame(atOnce, rest.solution());
    }
}
