package radiosity.mesh.cut;

import java.util.Arrays;
import java.util.stream.IntStream;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.EdgeKey;
import radiosity.util.Hash;
import radiosity.util.LongIndex;
import radiosity.util.PointNumbers;

/**
 * Cuts long quadrangles across, because division in four keeps the shape of a triangle: the wall of a corridor, or a
 * skirting board, would be meshed as finely across as along, or as coarsely along as across. A piece is about as long
 * as it is wide, or as a square patch where that is longer. The cuts depend on scene and patch area alone.
 *
 * <p>A quadrangle is two triangles of one surface in one plane with an edge in common: for both the longest, where
 * there is such a partner, else one of the longer two.
 */
public final class QuadSplitter {

    /** Ratio of mean length to mean width from which a quadrangle is cut. */
    private static final double LONG = 2;
    /** Largest length of the difference between unit normals of two triangles in one plane. */
    private static final double SAME_DIRECTION = 1e-5;
    /** Largest distance of the fourth corner from the plane of the others, in lengths of the common edge. */
    private static final double SAME_PLANE = 1e-6;

    private final Scene scene;
    /** Side of a square of the largest area of a patch, scene units: quadrangles that are no longer stay whole. */
    private final double patchSide;
    private final int[] number;
    private final LongIndex places;
    /** 3 per point: x, y, z, scene units. */
    private double[] points;
    private int pointCount;
    private final ScenePieces pieces;
    /** 1 per triangle of the given scene: where it has a partner, the corner from which their common edge goes on. */
    private final int[] shared;

    private QuadSplitter(Scene scene, double patchArea) {
        this.scene = scene;
        patchSide = Math.sqrt(patchArea);
        number = PointNumbers.of(scene.points());
        places = new LongIndex(16);
        points = scene.points().clone();
        pointCount = points.length / 3;
        pieces = new ScenePieces(scene);
        shared = new int[scene.triangles()];
    }

    /**
     * Cuts the long quadrangles of a scene; where no quadrangle is long, the scene stays the same.
     *
     * @param patchArea largest area of a patch, square scene units
     */
    public static ScenePieces.Cut cut(Scene scene, double patchArea) {
        QuadSplitter splitter = new QuadSplitter(scene, patchArea);
        int[] partner = splitter.partners();
        for (int t = 0; t < partner.length; t++) {
            if (partner[t] < 0) {
                splitter.pieces.add(t);
            } else if (partner[t] > t) {
                splitter.cut(t, partner[t]);
            }
        }
        int[] own = IntStream.range(0, partner.length).toArray();
        return splitter.pieces.count() == partner.length ? new ScenePieces.Cut(scene, own)
                : splitter.pieces.cut(Arrays.copyOf(splitter.points, 3 * splitter.pointCount), own);
    }

    /** 1 per triangle: the triangle with which it makes a long quadrangle, or -1. */
    private int[] partners() {
        int[] partner = new int[scene.triangles()];
        Arrays.fill(partner, -1);
        pair(partner, 0);
        pair(partner, 1);
        for (int t = 0; t < partner.length; t++) {
            if (partner[t] > t && pieces(quadrangle(t, shared[t], partner[t], shared[partner[t]])) == 1) {
                partner[partner[t]] = -1;
                partner[t] = -1;
            }
        }
        return partner;
    }

    /**
     * Pairs triangles that have none yet with those on the other side of an edge.
     *
     * @param rank which edge: 0 for the longest of a triangle; 1 for its longest two, as a trapezium's diagonal may be
     *             shorter than its longest side
     */
    private void pair(int[] partner, int rank) {
        LongIndex edges = new LongIndex(16);
        for (int t = 0; t < partner.length; t++) {
            for (int r = 0; r <= rank && partner[t] < 0 && ScenePieces.isPlain(scene, t); r++) {
                int k = longest(t, r);
                int p = number[corner(t, k)];
                int q = number[corner(t, k + 1)];
                if (edge(t, k) > patchSide) {
                    long key = Hash.mix(EdgeKey.of(p, q), scene.surfaceOf()[t]);
                    int u = edges.findOrAdd(Hash.mix(key, scene.hierarchy().of(t)), t);
                    int m = u == t || partner[u] >= 0 ? -1 : opposite(u, p, q);
                    if (m >= 0 && isFlat(t, k, u, m)) {
                        partner[t] = u;
                        partner[u] = t;
                        shared[t] = k;
                        shared[u] = m;
                    }
                }
            }
        }
    }

    /** The corner of a triangle from which an edge goes from q to p; -1 where there is none. */
    private int opposite(int t, int p, int q) {
        int found = -1;
        for (int k = 0; k < 3; k++) {
            if (number[corner(t, k)] == q && number[corner(t, k + 1)] == p) {
                found = k;
            }
        }
        return found;
    }

    private int corner(int t, int k) {
        return scene.corners()[3 * t + k % 3];
    }

    /** The corner k from which a triangle's longest (rank 0) or second longest edge (rank 1) goes to corner k + 1. */
    private int longest(int t, int rank) {
        double[] length = {edge(t, 0), edge(t, 1), edge(t, 2)};
        int first = length[0] >= length[1] && length[0] >= length[2] ? 0 : length[1] >= length[2] ? 1 : 2;
        int next = (first + 1) % 3;
        int last = (first + 2) % 3;
        return rank == 0 ? first : length[next] >= length[last] ? next : last;
    }

    private double edge(int t, int k) {
        return scene.corner(t, (k + 1) % 3).minus(scene.corner(t, k)).length();
    }

    /** Whether two triangles with an edge in common are a convex quadrangle in one plane. */
    private boolean isFlat(int t, int k, int u, int m) {
        int[] q = {corner(t, k), corner(u, m + 2), corner(t, k + 1), corner(t, k + 2)};
        Vec3 normal = scene.cross(t).unit();
        boolean isConvex = true;
        for (int i = 0; i < 4; i++) {
            Vec3 in = point(q[(i + 1) % 4]).minus(point(q[i]));
            isConvex &= in.cross(point(q[(i + 2) % 4]).minus(point(q[(i + 1) % 4]))).dot(normal) > 0;
        }
        return isConvex && (normal.minus(scene.cross(u).unit()).length() < SAME_DIRECTION
                || Math.abs(point(q[1]).minus(point(q[0])).dot(normal)) < SAME_PLANE * edge(t, k));
    }

    /** The four corners of a quadrangle, rotated so that the first and the third side are the long ones. */
    private int[] quadrangle(int t, int k, int u, int m) {
        int[] q = {corner(t, k), corner(u, m + 2), corner(t, k + 1), corner(t, k + 2)};
        return side(q, 0) + side(q, 2) >= side(q, 1) + side(q, 3) ? q : new int[] {q[1], q[2], q[3], q[0]};
    }

    private double side(int[] q, int k) {
        return point(q[(k + 1) % 4]).minus(point(q[k])).length();
    }

    private Vec3 point(int p) {
        return new Vec3(points[3 * p], points[3 * p + 1], points[3 * p + 2]);
    }

    /** Number of pieces into which a quadrangle is cut; 1 where it is not long. */
    private int pieces(int[] q) {
        double length = (side(q, 0) + side(q, 2)) / 2;
        Vec3 across = point(q[2]).minus(point(q[0])).cross(point(q[3]).minus(point(q[1])));
        double ratio = length * length / (across.length() / 2);
        return ratio < LONG ? 1 : (int) Math.min(Math.min(Math.round(ratio), Math.ceil(length / patchSide)), 1 << 10);
    }

    private void cut(int t, int u) {
        int[] q = quadrangle(t, shared[t], u, shared[u]);
        int n = pieces(q);
        for (int i = 0; i < n; i++) {
            int a = between(q[0], q[1], i, n);
            int b = between(q[0], q[1], i + 1, n);
            int c = between(q[3], q[2], i + 1, n);
            int d = between(q[3], q[2], i, n);
            pieces.add(a, b, c, isInside(t, a, b, c) ? t : u);
            pieces.add(a, c, d, isInside(t, a, c, d) ? t : u);
        }
    }

    /** Whether the middle of a piece of a quadrangle lies in the quadrangle's triangle t, not in the partner of t. */
    private boolean isInside(int t, int a, int b, int c) {
        Vec3 begin = point(corner(t, shared[t]));
        Vec3 along = point(corner(t, shared[t] + 1)).minus(begin);
        Vec3 middle = point(a).plus(point(b)).plus(point(c)).times(1.0 / 3);
        return along.cross(middle.minus(begin)).dot(scene.cross(t).unit()) > 0;
    }

    /** The point at i / n of the way between two points; the same point for all quadrangles on this edge. */
    private int between(int from, int to, int i, int n) {
        if (i == 0 || i == n) {
            return i == 0 ? from : to;
        }
        if (number[from] > number[to]) {
            return between(to, from, n - i, n);
        }
        int p = places.findOrAdd(Hash.mix((long) number[from] << 32 | number[to], (long) i << 32 | n), pointCount);
        if (p == pointCount) {
            points = 3 * p == points.length ? Arrays.copyOf(points, 2 * points.length) : points;
            Vec3 at = point(from).plus(point(to).minus(point(from)).times((double) i / n));
            points[3 * p] = at.x();
            points[3 * p + 1] = at.y();
            points[3 * p + 2] = at.z();
            pointCount++;
        }
        return p;
    }
}
