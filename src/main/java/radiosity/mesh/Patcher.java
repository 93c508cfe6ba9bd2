package radiosity.mesh;

import java.util.BitSet;
import java.util.List;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;

/**
 * How deep the initial mesh goes, and where its receiving points lie (section 4.2.1 of the paper).
 *
 * <p>Every face is divided in four until no patch is larger than the patch area. Neighbours share vertices within a
 * part. A vertex on the border of its part receives light a little inside it: at the exact edge of a room the form
 * factor of the adjacent wall is undefined.
 */
public final class Patcher {

    /** How far a receiving point is pulled inside, of the height of an element. */
    static final double PULL = 0.03;
    /** A patch smaller than this receives at its middle only, of the area of all faces; see {@link #isPoint}. */
    private static final double POINT = 0x1p-16;
    /** Largest of {@link #slack}. */
    public static final int MOST_SLACK = 3;
    /** In a part of this number of faces or more they have fewer shared corners than middles. */
    private static final int SHARED = 6;

    private final Faces faces;
    private final double patchArea;
    private final byte[] level;
    private final BitSet point;
    /** 9 per face: displacement of the receiving point at each of its corners. */
    private final float[] cornerPull;

    /**
     * @param patchArea largest area of a patch, of the scene's squared size, above 0
     * @param points    whether small patches may receive at one point
     */
    public Patcher(Faces faces, double patchArea, boolean points) {
        this(faces, patchArea, levels(faces, patchArea), points ? points(faces) : new BitSet());
    }

    private Patcher(Faces faces, double patchArea, byte[] level, BitSet point) {
        this.faces = faces;
        this.patchArea = patchArea;
        this.level = level;
        this.point = point;
        cornerPull = new ReceiverInset(faces, level).displacements();
    }

    private static byte[] levels(Faces faces, double patchArea) {
        byte[] level = new byte[faces.count()];
        for (int f = 0; f < level.length; f++) {
            for (double a = faces.area(f); a > patchArea && level[f] < NodePath.MAX_LEVEL; a /= 4) {
                level[f]++;
            }
        }
        return level;
    }

    private static BitSet points(Faces faces) {
        int[] size = new int[faces.count()];
        for (int f = 0; f < size.length; f++) {
            size[faces.part[f]]++;
        }
        BitSet points = new BitSet();
        for (int f = 0; f < size.length; f++) {
            points.set(f, size[faces.part[f]] < SHARED && faces.area(f) < POINT * faces.area());
        }
        return points;
    }

    /** A mesh of about this number of patches or of fewer, but with all the subtrees of these blocks. */
    public Patcher coarser(List<Block> blocks, int patches) {
        double largest = Math.max(patchArea, areaFor(faces, patches));
        byte[] coarse = levels(faces, largest);
        for (Block block : blocks) {
            for (int i = 0; i < block.face().length; i++) {
                int f = block.face()[i];
                coarse[f] = (byte) Math.max(coarse[f], NodePath.level(block.path()[i]));
            }
        }
        return new Patcher(faces, largest, coarse, point);
    }

    /** A patch area that gives about this number of patches. */
    public static double areaFor(Faces faces, int patches) {
        return Math.max(faces.area() / patches, Double.MIN_NORMAL);
    }

    public Faces faces() {
        return faces;
    }

    /** Largest area of a patch, of the scene's squared size. */
    public double patchArea() {
        return patchArea;
    }

    /** Divisions in four from face to patch. */
    public int level(int face) {
        return level[face];
    }

    /**
     * Whether a face is a patch that receives at its middle only: what was modelled finer than light needs, and shares
     * no corners in one plane with others, would have three points where one is as good.
     */
    public boolean isPoint(int face) {
        return level[face] == 0 && point.get(face);
    }

    /**
     * By how many powers of two the light at a face's vertex may be less exact than elsewhere. A given error of the
     * whole costs least where more work would gain the same everywhere: work at a point goes with about 1 / error, what
     * it is good for with the area that the point stands for.
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
     * Where the light at a vertex is gathered.
     *
     * @param weights  weights of the face's corners at the vertex, 3 from {@code at}, units of 2^-30; not modified
     * @param depth    level of the elements that the vertex was made for
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
            if (weights[at + k] == 0 && (faces.border[face] >> k & 1) != 0) {
                float[] inward = new float[3];
                inward(face, k, PULL * faces.height(face) / (1L << depth), inward);
                add(receiver, to, inward, 0);
            }
        }
    }

    private static void add(float[] to, int at, float[] what, int from) {
        for (int a = 0; a < 3; a++) {
            to[at + a] += what[from + a];
        }
    }

    /** In the face's plane, at right angles to its edge k, towards the face. */
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
