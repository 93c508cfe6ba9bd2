package radiosity.visibility;

import java.util.Arrays;
import java.util.function.IntPredicate;
import radiosity.scene.Vec3;

/**
 * A bounding volume hierarchy over triangles, in arrays (section 2.4.1 and 4.5.9 of the paper). Answers whether a
 * triangle stands between two points, and which triangle a ray meets first; any number of threads may ask.
 *
 * <p>Triangles block from both sides. Coordinates are those of a scene brought to size 1 around the origin; all
 * tolerances are relative to that size.
 */
public final class RadiosityBounds {

    /*
     * A traversal is one loop without a stack, see BoundsLayout. A segment meets a box unless it leaves one of the
     * box's three slabs before it enters another (T. Kay, J. Kajiya, Ray tracing complex scenes, 1986). A processor
     * cannot predict which incoherent rays meet a box, so the last entry and the first exit are found without branches:
     * by comparing the bits of floats as integers, which have the order of the floats from 0 on, while the bits of
     * negative floats are below 0.
     *
     * The box test is written out in the loop of `blocker`, which makes the method too large for the JVM to inline. If
     * the JVM inlined the method into a caller, the values of the loop would be in memory instead of registers, and all
     * rays would take 1.3 to 1.5 times as long. CompiledRaysTest checks that.
     */

    /** Parts of a segment left out at each end: in units of the scene's size, and of the segment's length. */
    static final float END_ABSOLUTE = 4e-6f;
    static final float END_RELATIVE = 1e-5f;
    /**
     * Height above a surface at which rays begin, in units of the scene's size. As far apart are the surfaces of which
     * one covers the other ({@code Faces.COVERING}) and the sides of a sheet ({@link #THIN}).
     */
    public static final double LIFT = 1e-5;
    /** Length of a ray that crosses the whole scene from anywhere near it, in units of the scene's size. */
    public static final float ACROSS = 4;
    /** Distance of a triangle from a ray's beginning, in units of the scene's size, from which on it always counts. */
    public static final double COUNTS = END_ABSOLUTE + 2 * END_RELATIVE;
    /** Distance beyond all triangles at which a ray out of the scene ends, in units of the scene's size. */
    private static final double BEYOND = 0.01;
    /** Margin of a box around its content, in units of the scene's size. */
    private static final float PAD = 2e-6f;
    /** Upper bound of the shift of a point by rounding, relative to the sum of coordinates in the computation. */
    private static final float ROUNDING = 3e-7f;
    /** Least component of a direction, by absolute value: no quotient is an infinity or NaN. */
    private static final float LEAST = 1e-18f;
    private static final int ONE = bits(1);

    /** Distances whose quotient is at most this are the same. */
    static final double SAME_PLACE = 1 + 1e-6;
    /**
     * Distance, in units of the scene's size, by which the front of a sheet may lie behind its back: where both are
     * made of the same corners, these are rounded, and the diagonals may be others.
     */
    static final double THIN = LIFT;

    /**
     * A triangle that stood in the way of a ray: rays from one point are often stopped by the same one (E. Haines,
     * D. Greenberg, The light buffer: a shadow-testing accelerator, 1986). Not for two threads at once.
     */
    public static final class Blocker {

        private int place = -1;
    }

    private final float[] corners;
    private final float[] data;
    private final int root;
    /** Half the side of a cube around the origin; outside of it is no triangle. */
    private final double cube;

    /** @param corners x, y, z of three corners, 9 per triangle; kept, so the caller must not modify the array */
    public RadiosityBounds(float[] corners) {
        this(corners, true);
    }

    /** @param sparing whether boxes that do not pay are left out; false only to measure the time that this saves */
    public RadiosityBounds(float[] corners, boolean sparing) {
        this.corners = corners;
        int n = corners.length / 9;
        float[] low = new float[3 * n];
        float[] high = new float[3 * n];
        float farthest = 0;
        for (int i = 0; i < 3 * n; i++) {
            int k = 9 * (i / 3) + i % 3;
            low[i] = Math.min(corners[k], Math.min(corners[k + 3], corners[k + 6])) - PAD;
            high[i] = Math.max(corners[k], Math.max(corners[k + 3], corners[k + 6])) + PAD;
            farthest = Math.max(farthest, Math.max(-low[i], high[i]));
        }
        cube = farthest + BEYOND;
        BoundsTree tree = Reinsertion.improve(new BoundsBuilder(low, high).tree);
        data = new BoundsLayout(tree, corners, sparing).data;
        root = n == 0 ? BoundsLayout.END : BoundsLayout.ROOT;
    }

    /** Memory of boxes and packed triangles, bytes. */
    public long bytes() {
        return (long) Float.BYTES * data.length;
    }

    /** Number of triangles. */
    public int size() {
        return corners.length / 9;
    }

    /** Whether a triangle stands between two points, whose coordinates are rounded to floats first. */
    public boolean blocked(Vec3 from, Vec3 to) {
        return blocked((float) from.x(), (float) from.y(), (float) from.z(), (float) to.x(), (float) to.y(),
                (float) to.z());
    }

    /**
     * Whether no triangle stands in the way of a ray out of the scene. The ray ends where it leaves the cube around the
     * scene: the longer a segment, the farther from its beginning is a triangle that counts.
     *
     * @param direction length 1
     * @param last      what stood in the way of an earlier ray is tried first; modified where this ray is stopped
     */
    public boolean isFree(Vec3 from, Vec3 direction, Blocker last) {
        double way = Math.max(0, Math.min(outside(from.x(), direction.x()),
                Math.min(outside(from.y(), direction.y()), outside(from.z(), direction.z()))));
        float ox = (float) from.x();
        float oy = (float) from.y();
        float oz = (float) from.z();
        float tx = (float) (from.x() + way * direction.x());
        float ty = (float) (from.y() + way * direction.y());
        float tz = (float) (from.z() + way * direction.z());
        if (last.place >= 0 && isBetween(last.place, ox, oy, oz, tx, ty, tz)) {
            return false;
        }
        int found = blocker(ox, oy, oz, tx, ty, tz);
        last.place = found >= 0 ? found : last.place;
        return found < 0;
    }

    /**
     * Distance along a ray to the side of the cube across one axis.
     *
     * @param from coordinate of the ray's beginning on that axis
     * @param step component of the ray's direction, which has length 1, on that axis
     */
    private double outside(double from, double step) {
        return step == 0 ? Double.POSITIVE_INFINITY : (step > 0 ? cube - from : -cube - from) / step;
    }

    /** Whether a triangle stands between the points o and t; a triangle that touches an end does not count. */
    public boolean blocked(float ox, float oy, float oz, float tx, float ty, float tz) {
        return blocker(ox, oy, oz, tx, ty, tz) >= 0;
    }

    /** Where in {@code data} a triangle is that stands between the points o and t; below 0 where none does. */
    private int blocker(float ox, float oy, float oz, float tx, float ty, float tz) {
        float hx = 0.5f * (tx - ox);
        float hy = 0.5f * (ty - oy);
        float hz = 0.5f * (tz - oz);
        float mx = ox + hx;
        float my = oy + hy;
        float mz = oz + hz;
        float half = Math.abs(hx) + Math.abs(hy) + Math.abs(hz);
        float slack = ROUNDING * (1 + Math.abs(mx) + Math.abs(my) + Math.abs(mz) + half);
        float clear = slack + END_ABSOLUTE + END_RELATIVE * 2 * half;
        float ix = inverse(tx - ox);
        float iy = inverse(ty - oy);
        float iz = inverse(tz - oz);
        float[] d = data;
        int at = root;
        while (at != BoundsLayout.END) {
            float cx = (d[at] - ox) * ix;
            float cy = (d[at + 1] - oy) * iy;
            float cz = (d[at + 2] - oz) * iz;
            float ex = d[at + 3] * Math.abs(ix);
            float ey = d[at + 4] * Math.abs(iy);
            float ez = d[at + 5] * Math.abs(iz);
            int entry = Math.max(Math.max(bits(cx - ex), bits(cy - ey)), Math.max(bits(cz - ez), 0));
            int exit = Math.min(Math.min(bits(cx + ex), bits(cy + ey)), Math.min(bits(cz + ez), ONE));
            if (entry > exit) {
                at = bits(d[at + BoundsLayout.NEXT]);
                continue;
            }
            int block = bits(d[at + BoundsLayout.BLOCK]);
            int k = BoundsLayout.first(block);
            int last = BoundsLayout.last(block);
            for (; k < last; k += PackedTriangle.SIZE) {
                int meets = PackedTriangle.meets(d, k, mx, my, mz, hx, hy, hz, slack, clear);
                if (meets > 0 || meets == 0 && isBetween(k, ox, oy, oz, tx, ty, tz)) {
                    return k;
                }
            }
            at = block < 0 ? last : bits(d[at + BoundsLayout.NEXT]);
        }
        return -1;
    }

    /** Whether the triangle at a place stands between two points, computed in double. */
    private boolean isBetween(int at, float ox, float oy, float oz, float tx, float ty, float tz) {
        double[] origin = {ox, oy, oz};
        double[] direction = {(double) tx - ox, (double) ty - oy, (double) tz - oz};
        double[] hit = new double[3];
        int k = 9 * PackedTriangle.number(data, at);
        if (!PackedTriangle.cuts(corners, k, origin, direction, hit)
                || !PackedTriangle.separates(corners, k, origin, direction)) {
            return false;
        }
        double length = Math.sqrt(PackedTriangle.dot(direction, direction));
        double end = END_RELATIVE + END_ABSOLUTE / length;
        return hit[0] > end && hit[0] < 1 - end;
    }

    private static float inverse(float x) {
        return 1 / (Math.abs(x) > LEAST ? x : LEAST);
    }

    /**
     * Whether no part of a segment is in a node's box.
     *
     * @param ox  origin of the segment: ox, oy, oz
     * @param ix  1 over the components of its direction: ix, iy, iz
     * @param end bits of the float at which the segment ends, in units of the direction
     */
    private static boolean missed(float[] d, int at, float ox, float oy, float oz, float ix, float iy, float iz,
                                  int end) {
        float cx = (d[at] - ox) * ix;
        float cy = (d[at + 1] - oy) * iy;
        float cz = (d[at + 2] - oz) * iz;
        float ex = d[at + 3] * Math.abs(ix);
        float ey = d[at + 4] * Math.abs(iy);
        float ez = d[at + 5] * Math.abs(iz);
        int entry = Math.max(Math.max(bits(cx - ex), bits(cy - ey)), Math.max(bits(cz - ez), 0));
        int exit = Math.min(Math.min(bits(cx + ex), bits(cy + ey)), Math.min(bits(cz + ez), end));
        return entry > exit;
    }

    private static int bits(float x) {
        return Float.floatToRawIntBits(x);
    }

    /** The nearest triangle along a ray, whose origin and direction are rounded to floats first. */
    public int nearest(Vec3 origin, Vec3 direction, double far, float[] hit) {
        return nearest((float) origin.x(), (float) origin.y(), (float) origin.z(), (float) direction.x(),
                (float) direction.y(), (float) direction.z(), (float) far, hit);
    }

    /**
     * The nearest triangle along a ray.
     *
     * @param ox  origin: ox, oy, oz
     * @param dx  direction, of any length but 0: dx, dy, dz
     * @param far only hits nearer than far * |d| count
     * @param hit modified where a triangle is hit: distance in units of |d|, and the weights of corners 1 and 2
     * @return the number of the triangle, or -1
     */
    public int nearest(float ox, float oy, float oz, float dx, float dy, float dz, float far, float[] hit) {
        return nearest(ox, oy, oz, dx, dy, dz, far, 0, hit);
    }

    /** As {@link #nearestFront(float, float, float, float, float, float, float, boolean, float[])}. */
    public int nearestFront(Vec3 o, Vec3 d, double far, boolean backs, float[] hit) {
        return nearestFront((float) o.x(), (float) o.y(), (float) o.z(), (float) d.x(), (float) d.y(), (float) d.z(),
                (float) far, backs, hit);
    }

    /**
     * The nearest triangle that a ray meets from its front, the side on which its corners run counter-clockwise. Where
     * a front and a back lie in the same place, as the sides of a sheet do, the ray meets the front.
     *
     * @param ox    origin: ox, oy, oz
     * @param dx    direction, of length 1: dx, dy, dz
     * @param far   only hits nearer than this count
     * @param backs whether the ray meets backs, too; otherwise it passes through backs
     * @param hit   modified where a triangle is hit: distance, and the weights of corners 1 and 2
     * @return the number of the triangle, or -1
     */
    public int nearestFront(float ox, float oy, float oz, float dx, float dy, float dz, float far, boolean backs,
                            float[] hit) {
        return nearest(ox, oy, oz, dx, dy, dz, far, backs ? THIN : Double.POSITIVE_INFINITY, hit);
    }

    /** What is looked for among the triangles that a ray meets. */
    @FunctionalInterface
    public interface Hit {
        /** @param distance along the ray, in units of the length of its direction */
        boolean counts(int triangle, double distance);
    }

    /**
     * Whether a ray meets a triangle that counts.
     *
     * @param wanted triangles of which a hit may count; asked first, as that is cheaper than a hit
     * @param ox   origin: ox, oy, oz
     * @param dx   direction, of any length but 0: dx, dy, dz
     * @param near least distance that counts, in units of |d|
     * @param far  largest distance that counts, in units of |d|
     */
    public boolean meets(float ox, float oy, float oz, float dx, float dy, float dz, double near, double far,
                         IntPredicate wanted, Hit hit) {
        double[] origin = {ox, oy, oz};
        double[] direction = {dx, dy, dz};
        double[] cut = new double[3];
        float ix = inverse(dx);
        float iy = inverse(dy);
        float iz = inverse(dz);
        float[] d = data;
        int at = root;
        while (at != BoundsLayout.END) {
            if (missed(d, at, ox, oy, oz, ix, iy, iz, bits((float) far))) {
                at = bits(d[at + BoundsLayout.NEXT]);
                continue;
            }
            int block = bits(d[at + BoundsLayout.BLOCK]);
            int last = BoundsLayout.last(block);
            for (int k = BoundsLayout.first(block); k < last; k += PackedTriangle.SIZE) {
                int t = PackedTriangle.number(d, k);
                if (wanted.test(t) && PackedTriangle.cuts(corners, 9 * t, origin, direction, cut)
                        && cut[0] >= near && cut[0] <= far && hit.counts(t, cut[0])) {
                    return true;
                }
            }
            at = block < 0 ? last : bits(d[at + BoundsLayout.NEXT]);
        }
        return false;
    }

    /** Which triangles are looked for among those whose boxes meet a box. */
    @FunctionalInterface
    public interface Candidate {
        /** @param corners x, y, z of the triangle's corners, 9 from {@code at}; not to be modified */
        boolean counts(int triangle, float[] corners, int at);
    }

    /**
     * Whether a triangle that counts may have a point in a box: whether such a triangle's own box meets the box.
     *
     * @param low  least x, y, z of the box
     * @param high largest x, y, z of the box
     */
    public boolean touches(float[] low, float[] high, Candidate candidate) {
        float[] d = data;
        int at = root;
        while (at != BoundsLayout.END) {
            boolean isApart = false;
            for (int a = 0; a < 3; a++) {
                isApart |= d[at + a] - d[at + 3 + a] > high[a] || d[at + a] + d[at + 3 + a] < low[a];
            }
            if (isApart) {
                at = bits(d[at + BoundsLayout.NEXT]);
                continue;
            }
            int block = bits(d[at + BoundsLayout.BLOCK]);
            int last = BoundsLayout.last(block);
            for (int k = BoundsLayout.first(block); k < last; k += PackedTriangle.SIZE) {
                int t = PackedTriangle.number(d, k);
                if (touches(t, low, high) && candidate.counts(t, corners, 9 * t)) {
                    return true;
                }
            }
            at = block < 0 ? last : bits(d[at + BoundsLayout.NEXT]);
        }
        return false;
    }

    private boolean touches(int triangle, float[] low, float[] high) {
        boolean touches = true;
        for (int a = 0; a < 3; a++) {
            float x = corners[9 * triangle + a];
            float y = corners[9 * triangle + 3 + a];
            float z = corners[9 * triangle + 6 + a];
            touches &= Math.min(x, Math.min(y, z)) <= high[a] && Math.max(x, Math.max(y, z)) >= low[a];
        }
        return touches;
    }

    /** x, y, z of the three corners of a triangle, a copy. */
    public float[] corners(int triangle) {
        return Arrays.copyOfRange(corners, 9 * triangle, 9 * triangle + 9);
    }

    /** @param behind length by which triangles that are met from behind count as farther away, 0 or more */
    private int nearest(float ox, float oy, float oz, float dx, float dy, float dz, float far, double behind,
                        float[] hit) {
        double[] origin = {ox, oy, oz};
        double[] direction = {dx, dy, dz};
        double[] cut = new double[3];
        float ix = inverse(dx);
        float iy = inverse(dy);
        float iz = inverse(dz);
        float[] d = data;
        float reach = far;
        int found = -1;
        int at = root;
        while (at != BoundsLayout.END) {
            if (missed(d, at, ox, oy, oz, ix, iy, iz, bits(reach))) {
                at = bits(d[at + BoundsLayout.NEXT]);
                continue;
            }
            int block = bits(d[at + BoundsLayout.BLOCK]);
            int last = BoundsLayout.last(block);
            for (int k = BoundsLayout.first(block); k < last; k += PackedTriangle.SIZE) {
                int number = PackedTriangle.number(d, k);
                if (PackedTriangle.cuts(corners, 9 * number, origin, direction, cut) && cut[0] > 0) {
                    double counts = behind == 0 || PackedTriangle.faces(corners, 9 * number, direction) ? cut[0]
                            : cut[0] + behind;
                    if (counts < reach) {
                        found = number;
                        reach = (float) counts;
                        hit[0] = (float) cut[0];
                        hit[1] = (float) cut[1];
                        hit[2] = (float) cut[2];
                    }
                }
            }
            at = block < 0 ? last : bits(d[at + BoundsLayout.NEXT]);
        }
        return found;
    }
}
