package radiosity.visibility;

import java.util.Arrays;

/**
 * Builds a binary tree over boxes from the top down by the binned surface area heuristic (I. Wald, On fast construction
 * of SAH-based bounding volume hierarchies, 2007).
 *
 * <p>The builder reads only boxes, never a triangle. The same boxes give the same tree, bit for bit.
 */
final class BoundsBuilder {

    /** Largest number of boxes in a leaf. */
    static final int MAX_LEAF = 4;
    private static final int BINS = 32;
    /** Cost of visiting a node relative to that of testing one triangle. */
    private static final float NODE_COST = 1.2f;

    private final float[] low;
    private final float[] high;
    final BoundsTree tree;
    private final int[] order;

    /** 3 per bin: lowest and highest corner of the boxes in the bin; undefined where the bin is empty. */
    private final float[] binLow = new float[3 * BINS];
    private final float[] binHigh = new float[3 * BINS];
    private final int[] binCount = new int[BINS];
    private final float[] rightArea = new float[BINS];

    /**
     * @param low  3 per box: lowest corner; not modified
     * @param high 3 per box: highest corner; not modified
     */
    BoundsBuilder(float[] low, float[] high) {
        this.low = low;
        this.high = high;
        int n = low.length / 3;
        tree = new BoundsTree(n);
        order = tree.order;
        for (int i = 0; i < n; i++) {
            order[i] = i;
        }
        if (n > 0) {
            build(n);
        }
    }

    /**
     * Builds the tree depth first. The stack of nodes whose second child is still to be built is an array, as the tree
     * may be as deep as there are boxes.
     */
    private void build(int n) {
        int[] open = new int[n + 1];
        int depth = 0;
        int from = 0;
        int length = n;
        while (true) {
            int node = add(from, length);
            int left = length == 1 ? 0 : split(node, from, length);
            if (left > 0) {
                tree.second[node] = from + left;
                open[depth++] = node;
                length = left;
            } else if (depth == 0) {
                return;
            } else {
                int parent = open[--depth];
                from = tree.second[parent];
                length = tree.first[parent] + tree.count[parent] - from;
                tree.second[parent] = tree.nodes;
            }
        }
    }

    private int add(int from, int length) {
        float[] lowest = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY};
        float[] highest = {Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
        for (int i = from; i < from + length; i++) {
            for (int a = 0; a < 3; a++) {
                lowest[a] = Math.min(lowest[a], low[3 * order[i] + a]);
                highest[a] = Math.max(highest[a], high[3 * order[i] + a]);
            }
        }
        int node = tree.add(from, length);
        tree.bound(node, lowest, 0, highest, 0);
        return node;
    }

    /**
     * Parts the run of c boxes from f in two and returns the length of the left part, or 0 where a leaf is cheaper. The
     * sums leave out empty bins, as most nodes have few boxes.
     */
    private int split(int node, int f, int c) {
        int bestAxis = -1;
        int bestBin = 0;
        float bestCost = Float.POSITIVE_INFINITY;
        float[] range = new float[6];
        centreRange(f, c, range);
        for (int axis = 0; axis < 3; axis++) {
            float width = range[3 + axis] - range[axis];
            if (!(width > 0)) {
                continue;
            }
            fillBins(f, c, axis, range[axis], BINS / width);
            float right = 0;
            for (int b = BINS - 1, n = 0; b > 0; b--) {
                if (binCount[b] > 0) {
                    mergeBin(b, n == 0);
                    n += binCount[b];
                    right = n * mergedArea();
                }
                rightArea[b] = right;
            }
            for (int b = 0, n = 0; n + binCount[b] < c; b++) {
                if (binCount[b] == 0) {
                    continue;
                }
                mergeBin(b, n == 0);
                n += binCount[b];
                float cost = n * mergedArea() + rightArea[b + 1];
                if (cost < bestCost) {
                    bestCost = cost;
                    bestAxis = axis;
                    bestBin = b;
                }
            }
        }
        if (bestAxis < 0) {
            return c <= MAX_LEAF ? 0 : c / 2;
        }
        float area = 4 * BoundsTree.area(tree.box[6 * node + 3], tree.box[6 * node + 4], tree.box[6 * node + 5]);
        if (c <= MAX_LEAF && bestCost + NODE_COST * area >= c * area) {
            return 0;
        }
        return partition(f, c, bestAxis, bestBin, range[bestAxis],
                BINS / (range[3 + bestAxis] - range[bestAxis]));
    }

    private void centreRange(int f, int c, float[] range) {
        Arrays.fill(range, 0, 3, Float.POSITIVE_INFINITY);
        Arrays.fill(range, 3, 6, Float.NEGATIVE_INFINITY);
        for (int i = f; i < f + c; i++) {
            for (int a = 0; a < 3; a++) {
                float x = centre(order[i], a);
                range[a] = Math.min(range[a], x);
                range[3 + a] = Math.max(range[3 + a], x);
            }
        }
    }

    private float centre(int i, int axis) {
        return 0.5f * (low[3 * i + axis] + high[3 * i + axis]);
    }

    private int bin(int i, int axis, float from, float scale) {
        return Math.max(0, Math.min(BINS - 1, (int) ((centre(i, axis) - from) * scale)));
    }

    private void fillBins(int f, int c, int axis, float from, float scale) {
        Arrays.fill(binCount, 0);
        for (int i = f; i < f + c; i++) {
            int b = bin(order[i], axis, from, scale);
            boolean first = binCount[b]++ == 0;
            for (int a = 0; a < 3; a++) {
                float l = low[3 * order[i] + a];
                float h = high[3 * order[i] + a];
                binLow[3 * b + a] = first ? l : Math.min(binLow[3 * b + a], l);
                binHigh[3 * b + a] = first ? h : Math.max(binHigh[3 * b + a], h);
            }
        }
    }

    private final float[] merged = new float[6];

    private void mergeBin(int b, boolean first) {
        for (int a = 0; a < 3; a++) {
            merged[a] = first ? binLow[3 * b + a] : Math.min(merged[a], binLow[3 * b + a]);
            merged[3 + a] = first ? binHigh[3 * b + a] : Math.max(merged[3 + a], binHigh[3 * b + a]);
        }
    }

    private float mergedArea() {
        return BoundsTree.area(merged[3] - merged[0], merged[4] - merged[1], merged[5] - merged[2]);
    }

    private int partition(int f, int c, int axis, int lastLeft, float from, float scale) {
        int i = f;
        int j = f + c - 1;
        while (i <= j) {
            if (bin(order[i], axis, from, scale) <= lastLeft) {
                i++;
            } else {
                int t = order[i];
                order[i] = order[j];
                order[j--] = t;
            }
        }
        return i - f;
    }
}
