package radiosity.util;

import java.util.function.IntConsumer;
import java.util.function.IntPredicate;

/**
 * A balanced binary tree over boxes, which finds the boxes that come near a segment or reach into a region.
 *
 * <p>In double, because the boxes found affect values of the solution. The same boxes give the same tree.
 */
public final class BoxTree {

    private static final int LEAF = 8;

    /** 6 per box: low x, y, z, high x, y, z. */
    private final double[] boxes;
    private final int[] order;
    /** 6 per node, as {@link #boxes}; the children of node i are 2i + 1 and 2i + 2. */
    private final double[] bounds;
    /** 1 per node: the lowest number of a box below the node. */
    private final int[] lowest;

    /** The region in which boxes are searched for. */
    public interface Region {

        /**
         * Whether a box may reach into the region. Must be true for every box that holds such a box.
         *
         * @param boxes low x, y, z and high x, y, z, 6 from {@code at}; not modified
         */
        boolean meets(double[] boxes, int at);
    }

    /**
     * The boxes that overlap a box along each axis.
     *
     * @param box low x, y, z and high x, y, z, 6 from {@code of}; not modified, kept
     * @param by  least length of the overlap; negative where boxes may be as far apart
     */
    public static Region overlapping(double[] box, int of, double by) {
        return (boxes, at) -> {
            boolean overlaps = true;
            for (int a = 0; a < 3; a++) {
                overlaps &= boxes[at + a] <= box[of + 3 + a] - by && box[of + a] <= boxes[at + 3 + a] - by;
            }
            return overlaps;
        };
    }

    /** @param boxes low x, y, z and high x, y, z, 6 per box; not modified, kept */
    public BoxTree(double[] boxes) {
        this.boxes = boxes;
        int n = boxes.length / 6;
        order = new int[n];
        for (int i = 0; i < n; i++) {
            order[i] = i;
        }
        bounds = new double[6 * nodesAbove(n)];
        lowest = new int[nodesAbove(n)];
        if (n > 0) {
            build(0, 0, n);
        }
    }

    /** Where the corners of triangles are. */
    @FunctionalInterface
    public interface Corners {

        /** Coordinate of corner k of a triangle on an axis, each 0, 1 or 2. */
        double at(int triangle, int k, int axis);
    }

    /** The boxes around the triangles from 0 to n - 1, 6 per triangle, as the constructor takes them. */
    public static double[] around(int n, Corners corners) {
        double[] boxes = new double[6 * n];
        for (int i = 0; i < 3 * n; i++) {
            int t = i / 3;
            int a = i % 3;
            double p = corners.at(t, 0, a);
            double q = corners.at(t, 1, a);
            double r = corners.at(t, 2, a);
            boxes[6 * t + a] = Math.min(p, Math.min(q, r));
            boxes[6 * t + 3 + a] = Math.max(p, Math.max(q, r));
        }
        return boxes;
    }

    /**
     * A tree over points.
     *
     * @param points x, y, z, 3 per point; not modified, not kept
     */
    public static BoxTree ofPoints(double[] points) {
        double[] boxes = new double[2 * points.length];
        for (int i = 0; i < points.length / 3; i++) {
            System.arraycopy(points, 3 * i, boxes, 6 * i, 3);
            System.arraycopy(points, 3 * i, boxes, 6 * i + 3, 3);
        }
        return new BoxTree(boxes);
    }

    private static int nodesAbove(int n) {
        int levels = 1;
        for (int run = n; run > LEAF; run = (run + 1) / 2) {
            levels++;
        }
        return (1 << levels) - 1;
    }

    private void build(int node, int from, int to) {
        bound(node, from, to);
        if (to - from > LEAF) {
            int middle = (from + to + 1) >>> 1;
            select(from, to - 1, middle, widestAxis(node));
            build(2 * node + 1, from, middle);
            build(2 * node + 2, middle, to);
        }
    }

    private void bound(int node, int from, int to) {
        lowest[node] = Integer.MAX_VALUE;
        for (int i = from; i < to; i++) {
            lowest[node] = Math.min(lowest[node], order[i]);
        }
        for (int a = 0; a < 3; a++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                low = Math.min(low, boxes[6 * order[i] + a]);
                high = Math.max(high, boxes[6 * order[i] + 3 + a]);
            }
            bounds[6 * node + a] = low;
            bounds[6 * node + 3 + a] = high;
        }
    }

    private int widestAxis(int node) {
        int widest = 0;
        for (int a = 1; a < 3; a++) {
            if (width(node, a) > width(node, widest)) {
                widest = a;
            }
        }
        return widest;
    }

    private double width(int node, int axis) {
        return bounds[6 * node + 3 + axis] - bounds[6 * node + axis];
    }

    private double centre(int box, int axis) {
        return boxes[6 * box + axis] + boxes[6 * box + 3 + axis];
    }

    /** Quickselect: afterwards no box centre before index {@code k} lies beyond a centre at {@code k} or later. */
    private void select(int from, int to, int k, int axis) {
        int left = from;
        int right = to;
        while (left < right) {
            double pivot = centre(order[(left + right) >>> 1], axis);
            int i = left;
            int j = right;
            while (i <= j) {
                while (centre(order[i], axis) < pivot) {
                    i++;
                }
                while (centre(order[j], axis) > pivot) {
                    j--;
                }
                if (i <= j) {
                    int swap = order[i];
                    order[i++] = order[j];
                    order[j--] = swap;
                }
            }
            if (k > j && k < i) {
                return;
            }
            if (k <= j) {
                right = j;
            } else {
                left = i;
            }
        }
    }

    /**
     * Finds every box that a segment comes near, and sometimes a box that it just misses.
     *
     * @param a     first end, 3 coordinates; not modified
     * @param b     other end, 3 coordinates; not modified; may equal a
     * @param near  largest distance along each axis
     * @param found receives the numbers of the boxes, in no particular order
     */
    public void near(double[] a, double[] b, double near, IntConsumer found) {
        double[] segment = new double[6];
        for (int i = 0; i < 3; i++) {
            segment[i] = 0.5 * (a[i] + b[i]);
            segment[3 + i] = 0.5 * (b[i] - a[i]);
        }
        any((some, at) -> !apart(some, at, segment, near), i -> {
            found.accept(i);
            return false;
        });
    }

    /**
     * The lowest number of a box that a point comes near, or -1. Tests few boxes, however many are near.
     *
     * @param p    3 coordinates; not modified
     * @param near largest distance along each axis
     */
    public int lowest(double[] p, double near) {
        double[] segment = {p[0], p[1], p[2], 0, 0, 0};
        return lowest((some, at) -> !apart(some, at, segment, near));
    }

    /** The lowest number of a box that meets a region, or -1. */
    int lowest(Region region) {
        int found = order.length == 0 ? Integer.MAX_VALUE : lowest(0, 0, order.length, region, Integer.MAX_VALUE);
        return found == Integer.MAX_VALUE ? -1 : found;
    }

    /** @return the lowest number of a box below a node that meets a region if lower than {@code best}, else that */
    private int lowest(int node, int from, int to, Region region, int best) {
        if (lowest[node] >= best || !region.meets(bounds, 6 * node)) {
            return best;
        }
        int found = best;
        if (to - from > LEAF) {
            int middle = (from + to + 1) >>> 1;
            int one = 2 * node + 1;
            int other = 2 * node + 2;
            if (lowest[one] < lowest[other]) {
                found = lowest(one, from, middle, region, found);
                return lowest(other, middle, to, region, found);
            }
            found = lowest(other, middle, to, region, found);
            return lowest(one, from, middle, region, found);
        }
        for (int i = from; i < to; i++) {
            if (order[i] < found && region.meets(boxes, 6 * order[i])) {
                found = order[i];
            }
        }
        return found;
    }

    /**
     * Whether one of the boxes that meet a region is wanted.
     *
     * @param wanted receives the numbers of the boxes, in no particular order, until it returns true
     */
    public boolean any(Region region, IntPredicate wanted) {
        return order.length > 0 && any(0, 0, order.length, region, wanted);
    }

    private boolean any(int node, int from, int to, Region region, IntPredicate wanted) {
        if (!region.meets(bounds, 6 * node)) {
            return false;
        }
        if (to - from > LEAF) {
            int middle = (from + to + 1) >>> 1;
            return any(2 * node + 1, from, middle, region, wanted) || any(2 * node + 2, middle, to, region, wanted);
        }
        for (int i = from; i < to; i++) {
            if (region.meets(boxes, 6 * order[i]) && wanted.test(order[i])) {
                return true;
            }
        }
        return false;
    }

    /** Separating-axis test with six axes: C. Ericson, Real-Time Collision Detection, 2005, 5.3.3. */
    private static boolean apart(double[] box, int k, double[] segment, double near) {
        double ex = 0.5 * (box[k + 3] - box[k]) + near;
        double ey = 0.5 * (box[k + 4] - box[k + 1]) + near;
        double ez = 0.5 * (box[k + 5] - box[k + 2]) + near;
        double cx = segment[0] - 0.5 * (box[k + 3] + box[k]);
        double cy = segment[1] - 0.5 * (box[k + 4] + box[k + 1]);
        double cz = segment[2] - 0.5 * (box[k + 5] + box[k + 2]);
        double ax = Math.abs(segment[3]);
        double ay = Math.abs(segment[4]);
        double az = Math.abs(segment[5]);
        return Math.abs(cx) > ex + ax || Math.abs(cy) > ey + ay || Math.abs(cz) > ez + az
                || Math.abs(segment[4] * cz - segment[5] * cy) > ey * az + ez * ay
                || Math.abs(segment[5] * cx - segment[3] * cz) > ex * az + ez * ax
                || Math.abs(segment[3] * cy - segment[4] * cx) > ex * ay + ey * ax;
    }
}
