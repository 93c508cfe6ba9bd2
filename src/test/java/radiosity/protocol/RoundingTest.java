package radiosity.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.mesh.PatchTree;

/** Radiosities that are rounded to few digits. */
class RoundingTest {

    private static PatchTree upward(double[] corners) {
        PatchTree tree = new PatchTree(7, 1, new int[] {-1}, corners);
        return new Rounding(false, true).upward(new Shot(List.of(tree), 0)).trees().get(0);
    }

    @Test
    void whatHasShotALittleTooLittleBesideABrightOne_hasNotShotLessThanNothingAfterwards() {
        double shot = -1e-4;
        double[] unshot = {1, -shot, .5};
        assertTrue(shot + upward(unshot).radiosity()[1] >= 0);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void upwardIsNeverLess_andFitsIntoBytes(int seed) throws IOException {
        for (double scale = 0.5; scale < 1.01; scale += 1.0 / 1024) {
            double[] unshot = new Random(seed).doubles(3, -scale, scale).toArray();
            unshot[0] = scale;
            PatchTree rounded = upward(unshot);
            for (int i = 0; i < 3; i++) {
                assertTrue(rounded.radiosity()[i] >= unshot[i], scale + " " + i);
                assertEquals(unshot[i], rounded.radiosity()[i], scale / 32);
            }
            byte[] written = Wire.bytes(out -> TreeBytes.write(rounded, 1, out));
            assertEquals(ShortestNumbers.BYTES, ShortestNumbers.of(rounded.radiosity(),
                    Quantizer.of(rounded.radiosity(), 1)));
            try (DataInputStream in = Wire.input(written)) {
                assertEquals(rounded.radiosity()[1], TreeBytes.read(in, 1).radiosity()[1]);
            }
        }
    }
}
