package radiosity.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import radiosity.mesh.face.NodePath;

/** Trees with fewer elements, and with those of two. */
class PrunedTreeTest {

    private static final int CHANNELS = 3;
    private static final int LEVELS = 3;
    /** A triangle in four, whose last part and its second part are in four again. */
    private static final int[] DEEP = {1, -1, -1, -1, 5, -1, 9, -1, -1, -1, -1, -1, -1};
    private static final int[] FLAT = {-1};
    /** Whose first part is in four. */
    private static final int[] OTHER = {1, 5, -1, -1, -1, -1, -1, -1, -1};

    private static int[] full() {
        int[] child = new int[(int) ((Math.pow(4, LEVELS + 1) - 1) / 3)];
        for (int i = 0; i < child.length; i++) {
            child[i] = 4 * i + 1 < child.length ? 4 * i + 1 : -1;
        }
        return child;
    }

    /** Values that are exact in the middle of edges, too. */
    private static double[] values(int nodes, long seed) {
        return new Random(seed).ints(3L * CHANNELS * nodes, -1000, 1000).mapToDouble(i -> i * 64).toArray();
    }

    private static PatchTree linear() {
        return new PatchTree(0, NodePath.FACE, FLAT, values(1, 1));
    }

    @Test
    void linear_becomesOneElement() {
        PatchTree pruned = linear().divided(full()).pruned(0);
        assertArrayEquals(FLAT, pruned.child());
        assertArrayEquals(linear().radiosity(), pruned.radiosity());
    }

    @Test
    void noElementBecomesLargerThanThatLevel() {
        for (int level = 0; level <= LEVELS + 1; level++) {
            PatchTree pruned = linear().divided(full()).pruned(level);
            int levels = Math.min(level, LEVELS);
            assertEquals((int) ((Math.pow(4, levels + 1) - 1) / 3), pruned.child().length, "level " + level);
            assertArrayEquals(linear().divided(full()).radiosity(), pruned.divided(full()).radiosity());
        }
    }

    @Test
    void meansOfAnyLevel_haveTheMeanOfTheWhole() {
        for (int[] child : new int[][] {full(), DEEP, FLAT}) {
            PatchTree tree = new PatchTree(0, NodePath.FACE, child, values(child.length, 3));
            for (int level = 0; level <= LEVELS + 1; level++) {
                PatchTree means = tree.mean(level);
                assertArrayEquals(mean(tree), mean(means), 1e-9, "level " + level);
                assertTrue(means.child().length <= (Math.pow(4, level + 1) - 1) / 3, "level " + level);
                assertArrayEquals(level > LEVELS ? child : means.child(), means.child());
            }
        }
    }

    private static double[] mean(PatchTree tree) {
        double[] mean = new double[CHANNELS];
        tree.addMean(0, 1, mean);
        return mean;
    }

    @Test
    void whatIsNotLinear_stays() {
        for (int i = 21; i < full().length; i++) {
            PatchTree tree = linear().divided(full());
            tree.radiosity()[3 * CHANNELS * i + i % (3 * CHANNELS)] += 1;
            PatchTree pruned = tree.pruned(0);
            assertEquals(1 + 4 * LEVELS, pruned.child().length, "element " + i);
            assertArrayEquals(tree.radiosity(), pruned.divided(full()).radiosity(), "element " + i);
        }
    }

    @Test
    void whereNothingIsLinear_itIsTheSameTree() {
        PatchTree tree = new PatchTree(0, NodePath.FACE, DEEP, values(DEEP.length, 2));
        assertSame(tree, tree.pruned(0));
    }

    @Test
    void theSumOfTwo_isOnTheElementsOfBoth() {
        PatchTree a = new PatchTree(0, NodePath.FACE, DEEP, elementsOnly(DEEP, 3));
        PatchTree b = new PatchTree(0, NodePath.FACE, OTHER, elementsOnly(OTHER, 4));
        PatchTree sum = a.plus(b);
        assertEquals(1 + 4 * 4, sum.child().length);
        assertArrayEquals(b.plus(a).radiosity(), sum.radiosity());
        double[] both = a.divided(full()).radiosity();
        double[] added = b.divided(full()).radiosity();
        for (int i = 0; i < both.length; i++) {
            both[i] += added[i];
        }
        assertArrayEquals(both, sum.divided(full()).radiosity());
    }

    private static double[] elementsOnly(int[] child, long seed) {
        double[] values = values(child.length, seed);
        for (int i = 0; i < values.length; i++) {
            values[i] = child[i / (3 * CHANNELS)] < 0 ? values[i] : 0;
        }
        return values;
    }
}
