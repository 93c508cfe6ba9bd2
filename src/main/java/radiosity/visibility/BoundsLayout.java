package radiosity.visibility;

import java.util.Locale;
import radiosity.util.ArraySize;
import radiosity.util.TooLargeException;

/**
 * Lays out a binary tree of boxes and its triangles in one array, in the order in which rays read them.
 *
 * <p>Boxes whose test costs more than it saves are left out, so a node may have any number of children, and triangles
 * beside the children. The child most likely to block a ray comes first.
 */
final class BoundsLayout {

    /*
     * A node has 8 numbers: centre and half extent of its box, then as bits NEXT, the place where a ray goes on after
     * it has missed the box or tested its content, and BLOCK, the content of the box. A block holds triangles, then the
     * nodes of all children one after another, so that siblings share cache lines. BLOCK is 4 * place + number of
     * triangles, with the sign bit set where children follow the triangles; places are multiples of 4.
     *
     * A box is tested once per visit of the node around it, and saves the test of its content where a ray misses it.
     * The probability that a ray meets a box is in proportion to the box's area (J. Goldsmith, J. Salmon, Automatic
     * creation of object hierarchies for ray tracing, 1987), so a box pays if
     * area(around) < (area(around) - area(box)) * tests(content).
     * Order of children: J. Nah, D. Manocha, SATO: surface area traversal order for shadow ray tracing, 2014.
     */
    static final int NODE = 8;
    static final int NEXT = 6;
    static final int BLOCK = 7;
    /** Place of the root, and the place that ends a traversal. */
    static final int ROOT = NODE;
    static final int END = 0;
    /** Largest number of triangles in a block: the number has 4 bits. */
    private static final int MOST_TRIANGLES = 15;

    /** Time to test a triangle relative to the time to test a box. */
    private static final float TRIANGLE_COST = 1.4f;
    /** Largest length of the array: the bits of a larger BLOCK could be a NaN, which the JVM need not preserve. */
    private static final int MOST_PLACES = 0x7F800000 >>> 2;

    private final BoundsTree tree;
    private final float[] corners;
    /** 1 per node of the tree: an eighth of the surface of its box. */
    private final float[] area;
    /** 1 per node of the tree: surface of its triangles relative to the surface of its box, times a constant. */
    private final float[] density;
    /** 1 per node of the tree: whether its box is left out. */
    private final boolean[] open;

    /** The nodes and triangles. */
    final float[] data;
    private int end;

    /**
     * @param tree    tree over the boxes of the triangles
     * @param corners 9 per triangle; not modified
     * @param sparing whether boxes whose test costs more than it saves are left out
     * @throws TooLargeException where the nodes and triangles do not fit into an array
     */
    BoundsLayout(BoundsTree tree, float[] corners, boolean sparing) {
        this.tree = tree;
        this.corners = corners;
        area = new float[tree.nodes];
        density = new float[tree.nodes];
        open = new boolean[tree.nodes];
        int triangles = tree.order.length;
        measure();
        int boxes = sparing ? weigh() : tree.nodes;
        data = new float[length(boxes, triangles)];
        if (triangles > 0) {
            layOut(boxes);
        }
    }

    /** Length of the array for some boxes and triangles. */
    static int length(int boxes, int triangles) {
        return ArraySize.within(String.format(Locale.ROOT, "bounding volumes of %,d triangles", triangles), MOST_PLACES,
                ROOT + (double) NODE * boxes + (double) PackedTriangle.SIZE * triangles);
    }

    /** Place at which a block's triangles begin. */
    static int first(int block) {
        return (block & Integer.MAX_VALUE) >>> 2 & -4;
    }

    /** Place at which a block's triangles end and its children begin. */
    static int last(int block) {
        return first(block) + PackedTriangle.SIZE * (block & MOST_TRIANGLES);
    }

    /** Computes area and density of all nodes, from the leaves to the root. */
    private void measure() {
        for (int i = tree.nodes - 1; i >= 0; i--) {
            area[i] = BoundsTree.area(tree.box[6 * i + 3], tree.box[6 * i + 4], tree.box[6 * i + 5]);
            if (tree.second[i] >= 0) {
                density[i] = (density[i + 1] * area[i + 1] + density[tree.second[i]] * area[tree.second[i]]) / area[i];
            } else {
                for (int k = tree.first[i]; k < tree.first[i] + tree.count[i]; k++) {
                    density[i] += PackedTriangle.doubleArea(corners, 9 * tree.order[k]) / area[i];
                }
            }
        }
    }

    /** Decides which boxes to leave out, from the leaves to the root; returns the number of boxes that stay. */
    private int weigh() {
        float[] tests = new float[tree.nodes];
        int[] loose = new int[tree.nodes];
        int left = 0;
        for (int i = tree.nodes - 1; i >= 0; i--) {
            if (tree.second[i] < 0) {
                tests[i] = TRIANGLE_COST * tree.count[i];
                loose[i] = tree.count[i];
                continue;
            }
            for (int child = i + 1; child > 0; child = child == i + 1 ? tree.second[i] : 0) {
                open[child] = 2 * loose[child] <= MOST_TRIANGLES && area[i] >= (area[i] - area[child]) * tests[child];
                tests[i] += open[child] ? tests[child] : 1;
                loose[i] += open[child] ? loose[child] : 0;
                left += open[child] ? 1 : 0;
            }
        }
        return tree.nodes - left;
    }

    /** Writes all nodes and blocks depth first; the stack of nodes whose blocks are to come is an array. */
    private void layOut(int boxes) {
        int[] from = new int[boxes + 1];
        int[] to = new int[boxes + 1];
        int[] children = new int[tree.order.length];
        int[] walk = new int[tree.nodes];
        int depth = 1;
        to[0] = ROOT;
        end = ROOT;
        putNode(0, END);
        while (depth > 0) {
            depth--;
            int node = from[depth];
            int at = to[depth];
            int begin = end;
            int inside = enter(node, walk, children);
            int triangles = (end - begin) / PackedTriangle.SIZE;
            data[at + BLOCK] = Float.intBitsToFloat(begin << 2 | triangles | (inside > 0 ? Integer.MIN_VALUE : 0));
            sort(children, inside);
            int next = Float.floatToRawIntBits(data[at + NEXT]);
            for (int c = 0; c < inside; c++) {
                int slot = depth + inside - 1 - c;
                from[slot] = children[c];
                to[slot] = end;
                putNode(children[c], c < inside - 1 ? end + NODE : next);
            }
            depth += inside;
        }
    }

    /**
     * Writes the triangles of a node's block.
     *
     * @param walk     scratch, 1 per node of the tree
     * @param children modified: the nodes of the boxes directly inside the node's box
     * @return number of these boxes
     */
    private int enter(int node, int[] walk, int[] children) {
        int inside = 0;
        int depth = 0;
        walk[depth++] = node;
        while (depth > 0) {
            int i = walk[--depth];
            if (i != node && !open[i]) {
                children[inside++] = i;
            } else if (tree.second[i] >= 0) {
                walk[depth++] = tree.second[i];
                walk[depth++] = i + 1;
            } else {
                placeRun(tree.first[i], tree.first[i] + tree.count[i]);
            }
        }
        return inside;
    }

    private void placeRun(int from, int to) {
        for (int k = from; k < to; k++) {
            PackedTriangle.put(corners, 9 * tree.order[k], data, end);
            end += PackedTriangle.SIZE;
        }
    }

    private void putNode(int node, int next) {
        System.arraycopy(tree.box, 6 * node, data, end, 6);
        data[end + NEXT] = Float.intBitsToFloat(next);
        end += NODE;
    }

    /** Sorts n nodes by falling density. By insertion, as there are few. */
    private void sort(int[] children, int n) {
        for (int i = 1; i < n; i++) {
            int child = children[i];
            int k = i;
            for (; k > 0 && density[children[k - 1]] < density[child]; k--) {
                children[k] = children[k - 1];
            }
            children[k] = child;
        }
    }
}
