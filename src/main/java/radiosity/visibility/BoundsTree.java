package radiosity.visibility;

/** A binary tree of boxes, depth first: an inner node's first child follows it. */
final class BoundsTree {

    /** The numbers of what is sorted, so that every node holds a run of them. */
    final int[] order;
    /** 6 per node: centre and half extent. */
    final float[] box;
    /** 1 per node: its second child, or -1 for a leaf. */
    final int[] second;
    /** 1 per node: where its run in {@link #order} begins. */
    final int[] first;
    /** 1 per node: length of its run. */
    final int[] count;
    int nodes;

    /** Without nodes. */
    BoundsTree(int sorted) {
        int most = Math.max(1, 2 * sorted);
        order = new int[sorted];
        box = new float[6 * most];
        second = new int[most];
        first = new int[most];
        count = new int[most];
    }

    /** A node that has no children yet. */
    int add(int from, int length) {
        first[nodes] = from;
        count[nodes] = length;
        second[nodes] = -1;
        return nodes++;
    }

    /** Gives a node the box between two corners: 3 numbers of each, from a place on. */
    void bound(int node, float[] low, int l, float[] high, int h) {
        for (int a = 0; a < 3; a++) {
            float lo = low[l + a];
            float hi = high[h + a];
            float centre = 0.5f * (lo + hi);
            box[6 * node + a] = centre;
            box[6 * node + 3 + a] = Math.max(hi - centre, centre - lo);
        }
    }

    /** Adds a node of another tree and all below it, whose run is to begin at a place; they end at a node. */
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
