package radiosity.visibility;

import java.util.PriorityQueue;

/** The largest boxes of a tree, from the root down, in a form in which boxes can be moved. */
final class TopLevelBvh {

    private final BoundsTree tree;
    /** 1 per box: its children; left is -1 where the box stands for a node of the tree and all nodes below it. */
    final int[] left;
    final int[] right;
    /** 1 per box: its parent; -1 for the root, which is box 0. */
    final int[] parent;
    /** 6 per box: lowest and highest corner; with room for one more box as scratch. */
    private final float[] box;
    /** 1 per box: half its surface. */
    final float[] area;
    /** 1 per box: its node in the original tree, and the end of the nodes below that node. */
    private final int[] node;
    private final int[] end;
    int boxes;

    /**
     * @param tree tree of one node or more
     * @param most largest number of boxes to take
     */
    TopLevelBvh(BoundsTree tree, int most) {
        this.tree = tree;
        left = new int[most];
        right = new int[most];
        parent = new int[most];
        box = new float[6 * most + 6];
        area = new float[most + 1];
        node = new int[most];
        end = new int[most];
        PriorityQueue<Integer> open = new PriorityQueue<>(this::byArea);
        open.add(add(0, tree.nodes, -1));
        while (!open.isEmpty() && boxes + 2 <= most) {
            int i = open.poll();
            int second = tree.second[node[i]];
            if (second >= 0) {
                left[i] = add(node[i] + 1, second, i);
                right[i] = add(second, end[i], i);
                open.add(left[i]);
                open.add(right[i]);
            }
        }
    }

    /** Order of boxes i and k: the larger one first. */
    int byArea(int i, int k) {
        return area[i] == area[k] ? Integer.compare(i, k) : Float.compare(area[k], area[i]);
    }

    private int add(int from, int to, int around) {
        for (int a = 0; a < 3; a++) {
            box[6 * boxes + a] = tree.box[6 * from + a] - tree.box[6 * from + 3 + a];
            box[6 * boxes + 3 + a] = tree.box[6 * from + a] + tree.box[6 * from + 3 + a];
        }
        area[boxes] = area(boxes);
        node[boxes] = from;
        end[boxes] = to;
        parent[boxes] = around;
        left[boxes] = -1;
        return boxes++;
    }

    private float area(int i) {
        return around(i, i);
    }

    /** Half the surface of the box around boxes i and k. */
    float around(int i, int k) {
        float x = Math.max(box[6 * i + 3], box[6 * k + 3]) - Math.min(box[6 * i], box[6 * k]);
        float y = Math.max(box[6 * i + 4], box[6 * k + 4]) - Math.min(box[6 * i + 1], box[6 * k + 1]);
        float z = Math.max(box[6 * i + 5], box[6 * k + 5]) - Math.min(box[6 * i + 2], box[6 * k + 2]);
        return BoundsTree.area(x, y, z);
    }

    /** Sets box {@code at} to the box around boxes i and k; any of the three may be the same. */
    void enclose(int at, int i, int k) {
        for (int a = 0; a < 3; a++) {
            box[6 * at + a] = Math.min(box[6 * i + a], box[6 * k + a]);
            box[6 * at + 3 + a] = Math.max(box[6 * i + 3 + a], box[6 * k + 3 + a]);
        }
        area[at] = area(at);
    }

    /** The sibling of a box that is not the root. */
    int beside(int i) {
        int around = parent[i];
        return left[around] == i ? right[around] : left[around];
    }

    /** Moves box i beside box {@code to}: its parent gives its place to the sibling and becomes the parent of both. */
    void move(int i, int to) {
        int around = parent[i];
        int other = beside(i);
        int outer = parent[around];
        replace(around, other);
        fit(outer);
        replace(to, around);
        left[around] = to;
        right[around] = i;
        parent[to] = around;
        fit(around);
    }

    private void replace(int old, int by) {
        int around = parent[old];
        if (left[around] == old) {
            left[around] = by;
        } else {
            right[around] = by;
        }
        parent[by] = around;
    }

    /** Fits a box and all boxes around it to their children. */
    private void fit(int from) {
        for (int i = from; i >= 0; i = parent[i]) {
            enclose(i, left[i], right[i]);
        }
    }

    /** The whole tree with the boxes where they have been moved. */
    BoundsTree write() {
        BoundsTree written = new BoundsTree(tree.order.length);
        write(0, 0, written);
        return written;
    }

    /** Writes a box and all boxes and nodes below it, whose run begins at a place; returns the end of the run. */
    private int write(int i, int place, BoundsTree to) {
        if (left[i] < 0) {
            to.append(tree, node[i], end[i], place);
            return place + tree.count[node[i]];
        }
        int at = to.add(place, 0);
        to.bound(at, box, 6 * i, box, 6 * i + 3);
        int middle = write(left[i], place, to);
        to.second[at] = to.nodes;
        int last = write(right[i], middle, to);
        to.count[at] = last - place;
        return last;
    }
}
