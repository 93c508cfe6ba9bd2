package radiosity.visibility;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** A tree of a room's walls and a cloud of small boxes between them, put together anew. */
class ReinsertionTest {

    private static final int SMALL = 3000;

    private static BoundsTree room() {
        Random random = new Random(3);
        float[] low = new float[3 * (SMALL + 6)];
        float[] high = new float[3 * (SMALL + 6)];
        for (int i = 0; i < 3 * SMALL; i++) {
            low[i] = 0.8f * random.nextFloat() - 0.4f;
            high[i] = low[i] + 0.02f * random.nextFloat();
        }
        for (int wall = 0; wall < 6; wall++) {
            int at = 3 * (SMALL + wall);
            Arrays.fill(low, at, at + 3, -0.5f);
            Arrays.fill(high, at, at + 3, 0.5f);
            (wall < 3 ? high : low)[at + wall % 3] = wall < 3 ? -0.5f : 0.5f;
        }
        return new BoundsBuilder(low, high).tree;
    }

    private static double area(BoundsTree tree) {
        double sum = 0;
        for (int i = 0; i < 6 * tree.nodes; i += 6) {
            float[] b = tree.box;
            sum += b[i + 3] * b[i + 4] + b[i + 4] * b[i + 5] + b[i + 5] * b[i + 3];
        }
        return sum;
    }

    /** Returns where the node's subtree ends. */
    private static int check(BoundsTree tree, int node) {
        if (tree.second[node] < 0) {
            return node + 1;
        }
        assertEquals(tree.second[node], check(tree, node + 1));
        assertEquals(tree.count[node], tree.count[node + 1] + tree.count[tree.second[node]]);
        for (int child : new int[] {node + 1, tree.second[node]}) {
            for (int a = 0; a < 3; a++) {
                float apart = Math.abs(tree.box[6 * child + a] - tree.box[6 * node + a]);
                assertTrue(apart + tree.box[6 * child + 3 + a] < tree.box[6 * node + 3 + a] + 5e-7f, "child outside");
            }
        }
        return check(tree, tree.second[node]);
    }

    @Test
    void boxesTogether_areSmaller() {
        BoundsTree tree = room();
        assertTrue(area(Reinsertion.improve(tree)) < 0.97 * area(tree));
    }

    @Test
    void theTree_isWhole() {
        BoundsTree tree = Reinsertion.improve(room());
        assertEquals(tree.nodes, check(tree, 0));
        int[] order = tree.order.clone();
        Arrays.sort(order);
        assertArrayEquals(IntStream.range(0, SMALL + 6).toArray(), order);
    }

    @Test
    void onlyATreeThatIsBetter_isAnother() {
        BoundsTree better = Reinsertion.improve(room());
        BoundsTree one = new BoundsBuilder(new float[3], new float[] {1, 1, 1}).tree;
        assertEquals(one, Reinsertion.improve(one));
        assertTrue(area(Reinsertion.improve(better)) <= area(better));
    }
}
