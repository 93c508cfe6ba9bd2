package radiosity.protocol;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.mesh.PatchTree;

/** What is shot is read as it was written, to the last bit, in as little room as it needs. */
class TreeBytesTest {

    /** Bytes that a unit takes; there is one. */
    private static final int UNIT = Short.BYTES;
    private static final int[] FOUR_PARTS = {1, -1, -1, -1, -1};

    /** What 12 corners have of 6 vertices: those of the triangle, then the middles of its edges. */
    private static final int[] VERTEX = {0, 5, 4, 5, 1, 3, 4, 3, 2, 3, 4, 5};

    private static PatchTree tree(double[] atVertices) {
        double[] radiosity = new double[3 * FOUR_PARTS.length];
        for (int i = 0; i < VERTEX.length; i++) {
            radiosity[3 + i] = atVertices[VERTEX[i]];
        }
        return new PatchTree(7, 1, FOUR_PARTS, radiosity);
    }

    private static double[] random(int seed) {
        return new Random(seed).doubles(6, -40, 1000).toArray();
    }

    private static byte[] written(PatchTree tree) {
        return Wire.bytes(out -> TreeBytes.write(tree, 1, out));
    }

    private static int checked(PatchTree tree) throws IOException {
        byte[] bytes = written(tree);
        DataInputStream in = Wire.input(bytes);
        assertArrayEquals(tree.radiosity(), TreeBytes.read(in, 1).radiosity());
        assertEquals(0, in.available());
        return bytes.length;
    }

    @Test
    void everyForm_losesNothing() throws IOException {
        PatchTree exact = tree(random(1));
        PatchTree floats = new Rounding(false, false).of(new Shot(List.of(exact), 0)).trees().get(0);
        int inDoubles = checked(exact);
        assertEquals(6 * (Double.BYTES - Float.BYTES), inDoubles - checked(floats));
        assertEquals(6 * (Double.BYTES - Byte.BYTES) - UNIT, inDoubles - checked(together(exact)));
    }

    private static PatchTree together(PatchTree tree) {
        return new Rounding(false, true).of(new Shot(List.of(tree), 0)).trees().get(0);
    }

    @Test
    void cornersThatDiffer_areAllWritten() throws IOException {
        PatchTree same = tree(random(2));
        double[] other = same.radiosity().clone();
        other[5] += 1;
        assertEquals(6 * Double.BYTES, checked(new PatchTree(7, 1, FOUR_PARTS, other)) - checked(same));
    }

    @Test
    void extremeNumbers_loseNothing() throws IOException {
        checked(tree(new double[6]));
        checked(tree(new double[] {Double.MIN_VALUE, 1, -1, 1e300, -1e-300, 0}));
        checked(tree(new double[] {Double.MAX_VALUE, Double.MIN_NORMAL, 0, 1, 2, 3}));
        checked(tree(new double[] {1e-310, 2e-310, 0, 0, 0, 0}));
    }

    /** What is left over is small beside the largest nearby, and is not lost: it stays to be shot. */
    @Test
    void rounding_leavesLittle() throws IOException {
        for (int seed = 3; seed < 300; seed++) {
            PatchTree before = tree(new Random(seed).doubles(6, -1, 1).map(x -> Math.pow(x, 9)).toArray());
            PatchTree after = together(before);
            checked(after);
            double most = DoubleStream.of(before.radiosity()).map(Math::abs).max().orElse(0);
            for (int i = 0; i < before.radiosity().length; i++) {
                assertEquals(before.radiosity()[i], after.radiosity()[i], most * 0x1p-7, "seed " + seed);
            }
        }
    }

    /** In a large tree, and in another channel, what is dark keeps its digits. */
    @Test
    void besideWhatIsBright_whatIsDarkKeepsItsDigits() {
        int[] deep = {1, 5, 9, 13, 17, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
        double[] radiosity = new double[3 * 3 * deep.length];
        for (int i = 3 * 3 * 5; i < radiosity.length; i++) {
            radiosity[i] = (i % 3 == 2 ? 1e-6 : 1) * (i < 3 * 3 * 13 ? 1000 + i : 1e-3 * (1 + 1e-3 * i));
        }
        double[] after = together(new PatchTree(7, 1, deep, radiosity)).radiosity();
        for (int i = 0; i < radiosity.length; i++) {
            assertEquals(radiosity[i], after[i], Math.abs(radiosity[i]) * 0x1p-7, "value " + i);
        }
    }

    /** The largest would need one digit more when it is rounded. */
    @Test
    void roundedUp_stillFits() throws IOException {
        double[] values = {127.9, -127.9, 64, 1, -1, 127.4};
        assertEquals(6 * (Double.BYTES - Byte.BYTES) - UNIT,
                checked(tree(random(1))) - checked(together(tree(values))));
    }

    @Test
    void unitThatIsNoNumber_isRefused() {
        byte[] bytes = written(together(tree(random(5))));
        bytes[4 + 8 + 4 + 1 + 1 + 1] = 0x7f;
        assertThrows(IOException.class, () -> TreeBytes.read(Wire.input(bytes), 1));
    }

    @ParameterizedTest
    @ValueSource(bytes = {-1, 2, 5, 9})
    void unknownForm_isRefused(byte form) {
        byte[] bytes = written(tree(random(4)));
        bytes[4 + 8 + 4 + 1] = form;
        assertThrows(IOException.class, () -> TreeBytes.read(Wire.input(bytes), 1));
    }
}
