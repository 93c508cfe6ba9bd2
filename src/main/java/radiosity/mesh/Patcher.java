package radiosity.mesh;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntPredicate;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.visibility.RadiosityBounds;

/**
 * Decides how deep the initial mesh goes, and where its receiving points lie (section 4.2.1 of the paper).
 *
 * <p>Every face is divided in four until no patch is larger than the patch area. Neighbouring faces share vertices
 * within a coplanar region. A vertex on the border of its region receives light at a point a little inside the region:
 * at the exact edge of a room the form factor of the adjacent wall is undefined.
 */
public final class Patcher {

    /** Distance by which a receiving point is pulled inside its region, in heights of an element. */
    static final double PULL = 0.03;
    /** Largest area of a patch that receives at its middle only, as share of all faces' area; see {@link #isPoint}. */
    public static final double POINT = 0x1p-16;
    /** Largest value of {@link #slack}. */
    public static final int MOST_SLACK = 3;
    /** Coplanar regions of this number of faces or more have fewer shared corners than middles of faces. */
    private static final int SHARED = 6;

    /** Tells which faces are divided at least once, and where the others receive. */
    public interface PointRule {

        /** Whether a face is divided, however small it is. */
        default boolean divides(int face) {
            return false;
        }

        /**
         * Where a face receives that has one receiving point.
         *
         * @param isSmall whether the face is so small that one point is enough for it
         * @return x, y, z in the scene brought to size 1; null where the face receives at its corners
         */
        float[] point(int face, boolean isSmall);
    }

    private final Faces faces;
    private final double patchArea;
    private final byte[] level;
    private final BitSet point;
    /** Receiving points, x, y, z, of those faces of {@link #point} that do not receive at their middle. */
    private final Map<Integer, float[]> moved;
    /** 9 per face: displacement of the receiving point at each corner of the face, x, y, z. */
    private final float[] cornerPull;

    /**
     * @param patchArea largest area of a patch, in squared scene sizes, above 0
     * @param rule      which faces are divided in any case, and where undivided faces receive
     */
    public Patcher(Faces faces, double patchArea, PointRule rule) {
        this(faces, patchArea, levels(faces, patchArea, rule::divides), new BitSet(), new HashMap<>());
        int[] size = new int[faces.count()];
        for (int f = 0; f < size.length; f++) {
            size[faces.part[f]]++;
        }
        for (int f = 0; f < size.length; f++) {
            boolean isSmall = size[faces.part[f]] < SHARED && faces.area(f) < POINT * faces.area();
            float[] at = level[f] == 0 ? rule.point(f, isSmall) : null;
            point.set(f, at != null);
            if (at != null && !Arrays.equals(at, faces.middle(f))) {
                moved.put(f, at);
            }
        }
    }

    private Patcher(Faces faces, double patchArea, byte[] level, BitSet point, Map<Integer, float[]> moved) {
        this.faces = faces;
        this.patchArea = patchArea;
        this.level = level;
        this.point = point;
        this.moved = moved;
        cornerPull = new ReceiverInset(faces, level).displacements();
    }

    private static byte[] levels(Faces faces, double patchArea, IntPredicate divides) {
        byte[] level = new byte[faces.count()];
        for (int f = 0; f < level.length; f++) {
            int deepest = 0;
            for (double a = faces.area(f); a > patchArea && deepest < NodePath.MAX_LEVEL; a /= 4) {
                deepest++;
            }
            level[f] = (byte) Math.max(deepest, divides.test(f) ? 1 : 0);
        }
        return level;
    }

    /** A mesh of about this number of patches or fewer, but deep enough to hold every subtree of some blocks. */
    public Patcher coarser(List<Block> blocks, int patches) {
        double largest = Math.max(patchArea, areaFor(faces, patches));
        byte[] coarse = levels(faces, largest, f -> false);
        for (Block block : blocks) {
            for (int i = 0; i < block.face().length; i++) {
                int f = block.face()[i];
                coarse[f] = (byte) Math.max(coarse[f], NodePath.level(block.path()[i]));
            }
        }
        return new Patcher(faces, largest, coarse, point, moved);
    }

    /** The patch area, in squared scene sizes, that gives about this number of patches. */
    public static double areaFor(Faces faces, int patches) {
        return Math.max(faces.area() / patches, Double.MIN_NORMAL);
    }

    public Faces faces() {
        return faces;
    }

    /** Largest area of a patch, in squared scene sizes. */
    public double patchArea() {
        return patchArea;
    }

    /** Levels from a face down to its patches. */
    public int level(int face) {
        return level[face];
    }

    /**
     * Whether a face is one patch with one receiving point, mostly its middle. Such a face is modelled finer than the
     * light needs and shares few corners with coplanar faces, so three receiving points would cost more and gain
     * nothing; or all its corners are covered.
     */
    public boolean isPoint(int face) {
        return level[face] == 0 && point.get(face);
    }

    /** The receiving point of a face that has one, x, y, z in the scene brought to size 1; not to be modified. */
    float[] point(int face) {
        float[] elsewhere = moved.get(face);
        return elsewhere == null ? faces.middle(face) : elsewhere;
    }

    /**
     * Number of powers of two, from 0 to {@link #MOST_SLACK}, by which the tolerance for light at a face's vertices is
     * raised. A given total error costs least where further work reduces it equally everywhere: the work at a point
     * grows with 1 / error, and its effect on the total with the area that the point represents.
     */
    public int slack(int face) {
        if (!isPoint(face)) {
            return 0;
        }
        double share = faces.area(face) / faces.area();
        return share > POINT / 4 ? 1 : share > POINT / 32 ? 2 : 3;
    }

    /** Number of patches in the whole scene. */
    public long patches() {
        long n = 0;
        for (byte l : level) {
            n += 1L << 2 * l;
        }
        return n;
    }

    /**
     * Finds the receiving point of a vertex.
     *
     * @param weights  weights of the face's corners at the vertex, 3 from {@code at}, units of 2^-30; not modified
     * @param depth    level of the elements for which the vertex is made
     * @param position x, y, z of the vertex, 3 from {@code to}; not modified
     * @param receiver modified: x, y, z of the receiving point, 3 from {@code to}
     */
    void pull(int face, int[] weights, int at, int depth, float[] position, float[] receiver, int to) {
        System.arraycopy(position, to, receiver, to, 3);
        for (int k = 0; k < 3; k++) {
            if (weights[at + k] == NodePath.ONE) {
                add(receiver, to, cornerPull, 9 * face + 3 * k);
                return;
            }
        }
        for (int k = 0; k < 3; k++) {
            if (weights[at + k] == 0 && faces.isBorder(face, k)) {
                float[] inward = new float[3];
                inward(face, k, inset(faces.height(face) / (1L << depth)), inward);
                add(receiver, to, inward, 0);
            }
        }
    }

    /**
     * Distance of a receiving point from the edge of a face, for elements of some height: so large that rays do not
     * pass through a wall on the edge, unless the element is too small for that.
     */
    private static double inset(double height) {
        return Math.max(PULL * height, Math.min(height / 3, RadiosityBounds.COUNTS));
    }

    private static void add(float[] to, int at, float[] what, int from) {
        for (int a = 0; a < 3; a++) {
            to[at + a] += what[from + a];
        }
    }

    /** Sets v to the normal of the edge opposite corner k that points into face f, scaled to a given length. */
    private void inward(int f, int k, double length, float[] v) {
        int p = (k + 1) % 3;
        int q = (k + 2) % 3;
        double ex = (double) faces.corner(f, q, 0) - faces.corner(f, p, 0);
        double ey = (double) faces.corner(f, q, 1) - faces.corner(f, p, 1);
        double ez = (double) faces.corner(f, q, 2) - faces.corner(f, p, 2);
        double nx = faces.normal(f, 0);
        double ny = faces.normal(f, 1);
        double nz = faces.normal(f, 2);
        double scale = length / Math.sqrt(ex * ex + ey * ey + ez * ez);
        v[0] = (float) ((ny * ez - nz * ey) * scale);
        v[1] = (float) ((nz * ex - nx * ez) * scale);
        v[2] = (float) ((nx * ey - ny * ex) * scale);
    }
}
