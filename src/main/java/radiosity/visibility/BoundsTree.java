package radiosity.visibility;

/** A binary tree of boxes in arrays, depth first: the first child of node i is node i + 1. */
final class BoundsTree {

    /** The numbers of the sorted items, ordered so that the items of every node are a run. */
    final int[] order;
    /** 6 per node: centre and half extent of its box. */
    final float[] box;
    /** 1 per node: its second child, or -1 for a leaf. */
    final int[] second;
    /** 1 per node: place in {@link #order} at which its run begins. */
    final int[] first;
    /** 1 per node: length of its run. */
    final int[] count;
    int nodes;

    /** A tree without nodes, with room for all nodes over this number of items. */
    BoundsTree(int sorted) {
        int most = Math.max(1, 2 * sorted);
        order = new int[sorted];
        box = new float[6 * most];
        second = new int[most];
        first = new int[most];
        count = new int[most];
    }

    /** Adds a leaf, whose box is not set yet; returns its number. */
    int add(int from, int length) {
        first[nodes] = from;
        count[nodes] = length;
        second[nodes] = -1;
        return nodes++;
    }

    /** Sets a node's box to the box between two corners: 3 numbers from l and 3 from h; these are not modified. */
    void bound(int node, float[] low, int l, float[] high, int h) {
        for (int a = 0; a < 3; a++) {
            float lo = low[l + a];
            float hi = high[h + a];
            float centre = 0.5f * (lo + hi);
            box[6 * node + a] = centre;
            box[6 * node + 3 + a] = Math.max(hi - centre, centre - lo);
        }
    }

    /** Half the surface of a box with sides x, y and z. */
    static float area(float x, float y, float z) {
        return x * y + y * z + z * x;
    }

    /** Appends the nodes {@code from} to {@code to - 1} of another tree, a subtree; its run begins at {@code place}. */
    void append(BoundsTree other, int from, int to, int place) {
        int begin = other.first[from];
        System.arraycopy(other.order, begin, order, place, other.count[from]);
        System.arraycopy(other.box, 6 * from, box, 6 * nodes, 6 * (to - from));
        int shift = nodes - from;
        for (int i = from; i < to; i++) {
            int node = add(other.first[i] - begin + place, other.count[i]);
            second[node] = other.second[i] < 0 ? -1 : other.second[i] + shift;
        }
    }
}
