package radiosity.patch;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.IntPredicate;
import radiosity.scene.Lamp;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/**
 * The sides of original triangles that radiate, brought to size 1 around the origin: the roots of the patch tree.
 *
 * <p>A two-sided triangle has two faces, any other has one. Triangles smaller than {@value #LEAST_AREA} of the scene's
 * squared size have none. Faces of one surface that meet along an edge in one plane are a <i>part</i>.
 */
public final class Faces {

    /** Of the scene's squared size. */
    public static final double LEAST_AREA = 1e-12;
    /** Importance of irradiance on a black face. */
    public static final double LEAST_IMPORTANCE = 0.05;
    /** What normals of faces in one plane differ by at most. */
    private static final float SAME_PLANE = 1e-5f;

    private final Scene scene;
    private final SceneBox box;
    private final Channels kinds;
    private final int channels;
    private int count;
    private int dropped;
    /** Corners of faces, those of the scene and those that cutting made. */
    private final CutPoints points;
    /** 1 per face: 2 * original triangle, + 1 for the back. */
    final int[] side;
    /** 9 per face: three corners, counter-clockwise seen from the side that radiates. */
    final float[] corner;
    /** 3 per face, length 1. */
    final float[] normal;
    /** 1 per face. */
    final double[] area;
    /** Their sum. */
    private double wholeArea;
    /** 3 per face: number of the point at each corner; equal coordinates have equal numbers. */
    final int[] point;
    /** 1 per face: the lowest face of its part. */
    final int[] part;
    /** 3 per face: which corners are one, as faces of a part lie all round between them: the lowest such corner. */
    final int[] fan;
    /** 1 per face: bit k where the edge opposite corner k is the part's border. */
    final byte[] border;
    /** 1 per face: whether it is a piece of a triangle that was cut. */
    private final boolean[] piece;
    private Shine shine;

    /** All light of a scene as one. */
    public Faces(Scene scene) {
        this(scene, false);
    }

    /** @param layered whether the light of each lamp is kept apart: in channels of its own */
    public Faces(Scene scene, boolean layered) {
        this(scene, SceneBox.of(scene), new Channels(scene, layered), new CutPoints(scene, 0), mostFaces(scene));
        int[] numbers = PointNumbers.of(scene.points());
        for (int t = 0; t < scene.triangles(); t++) {
            add(t, numbers);
        }
        finish(Set.of());
    }

    private Faces(Faces whole, Cutting cutting) {
        this(whole.scene, whole.box, whole.kinds, cutting.points,
                whole.count + cutting.count());
        dropped = whole.dropped;
        for (int f = 0; f < whole.count; f++) {
            List<int[]> some = cutting.pieces.get(f);
            if (some == null) {
                add(whole, f, whole.point[3 * f], whole.point[3 * f + 1], whole.point[3 * f + 2]);
                continue;
            }
            for (int[] p : some) {
                piece[count] = true;
                add(whole, f, p[0], p[1], p[2]);
            }
        }
        finish(cutting.edges);
    }

    /** @param most faces that there is to be room for */
    private Faces(Scene scene, SceneBox box, Channels kinds, CutPoints points, int most) {
        this.scene = scene;
        this.box = box;
        this.kinds = kinds;
        this.points = points;
        channels = kinds.colours * kinds.layers();
        side = new int[most];
        corner = new float[9 * most];
        normal = new float[3 * most];
        area = new double[most];
        point = new int[3 * most];
        part = new int[most];
        fan = new int[3 * most];
        border = new byte[most];
        piece = new boolean[most];
    }

    private void finish(Set<Long> cut) {
        new Parts(this).join(cut);
        shine = new Shine(this, kinds);
    }

    /**
     * The same with large faces cut where others stand on them or come through; as it is where nothing does, and where
     * so many do that there would be more pieces than elements.
     */
    public Faces cut() {
        Cutting cutting = new Cutting(this);
        return cutting.edges.isEmpty() || cutting.isTooFine() ? this : new Faces(this, cutting);
    }

    private void add(Faces whole, int face, int p, int q, int r) {
        Vec3 a = unit(points.at(p));
        Vec3 b = unit(points.at(q));
        Vec3 c = unit(points.at(r));
        double itsArea = b.minus(a).cross(c.minus(a)).length() / 2;
        if (itsArea < LEAST_AREA) {
            return;
        }
        add(whole.side[face], a, b, c, new Vec3(whole.normal(face, 0), whole.normal(face, 1), whole.normal(face, 2)),
                itsArea, p, q, r);
    }

    private static int mostFaces(Scene scene) {
        int n = 0;
        for (int t = 0; t < scene.triangles(); t++) {
            n += scene.surface(t).twoSided() ? 2 : 1;
        }
        return n;
    }

    private void add(int triangle, int[] points) {
        Vec3 a = unit(scene.corner(triangle, 0));
        Vec3 b = unit(scene.corner(triangle, 1));
        Vec3 c = unit(scene.corner(triangle, 2));
        Vec3 cross = b.minus(a).cross(c.minus(a));
        double twice = cross.length();
        if (twice < 2 * LEAST_AREA) {
            dropped++;
            return;
        }
        int p = scene.corners()[3 * triangle];
        int q = scene.corners()[3 * triangle + 1];
        int r = scene.corners()[3 * triangle + 2];
        Vec3 n = cross.times(1 / twice);
        add(2 * triangle, a, b, c, n, twice / 2, points[p], points[q], points[r]);
        if (scene.surface(triangle).twoSided()) {
            add(2 * triangle + 1, a, c, b, n.times(-1), twice / 2, points[p], points[r], points[q]);
        }
    }

    private void add(int id, Vec3 a, Vec3 b, Vec3 c, Vec3 n, double faceArea, int p, int q, int r) {
        side[count] = id;
        area[count] = faceArea;
        wholeArea += faceArea;
        put(corner, 9 * count, a);
        put(corner, 9 * count + 3, b);
        put(corner, 9 * count + 6, c);
        put(normal, 3 * count, n);
        point[3 * count] = p;
        point[3 * count + 1] = q;
        point[3 * count + 2] = r;
        count++;
    }

    private static void put(float[] to, int at, Vec3 v) {
        to[at] = (float) v.x();
        to[at + 1] = (float) v.y();
        to[at + 2] = (float) v.z();
    }

    /** A place in the scene, brought to size 1 around the origin. */
    public Vec3 unit(Vec3 p) {
        return box.unit(p);
    }

    /** Number of faces. */
    public int count() {
        return count;
    }

    /** Triangles that were too small to radiate. */
    public int dropped() {
        return dropped;
    }

    public Scene scene() {
        return scene;
    }

    /** Largest extent of the scene's box, scene units. */
    public double size() {
        return box.size();
    }

    /** {@link #colours} times {@link #layers}, layer by layer. */
    public int channels() {
        return channels;
    }

    /** 1 where everything in the scene is grey, else 3. */
    public int colours() {
        return kinds.colours;
    }

    /** As many as there are lamps where their light is kept apart, else 1. */
    public int layers() {
        return kinds.layers();
    }

    /** What has a layer of its own; empty where all light is kept as one. */
    public List<Lamp> lamps() {
        return kinds.lamps;
    }

    /** What a light's {@link radiosity.scene.Light#power()} is in a channel. */
    public double power(int light, int channel) {
        return kinds.isOf(false, light, channel) ? scene.lights().get(light).power().channel(channel % kinds.colours) : 0;
    }

    /** 3 per original triangle: normal of its visible side, 0 where both are visible. */
    public float[] fronts() {
        float[] fronts = new float[3 * scene.triangles()];
        for (int f = 0; f < count; f++) {
            for (int a = 0; a < 3 && !scene.surface(triangle(f)).twoSided(); a++) {
                fronts[3 * triangle(f) + a] = normal(f, a);
            }
        }
        return fronts;
    }

    /** The original triangle of a face. */
    public int triangle(int face) {
        return side[face] >> 1;
    }

    /** 2 * original triangle, + 1 for the back. */
    public int side(int face) {
        return side[face];
    }

    /** Area, of the scene's squared size. */
    public double area(int face) {
        return area[face];
    }

    /** Area of all faces, of the scene's squared size. */
    public double area() {
        return wholeArea;
    }

    /** Component a of a face's normal. */
    public float normal(int face, int a) {
        return normal[3 * face + a];
    }

    /**
     * The face whose plane stands for a face's: the lowest of its part, so that a vertex which faces share lies in the
     * same plane whichever of them it was made for; the face itself where it is bent away from that.
     */
    public int plane(int face) {
        int root = part[face];
        float off = 0;
        for (int a = 0; a < 3; a++) {
            off = Math.max(off, Math.abs(normal[3 * root + a] - normal[3 * face + a]));
        }
        return off < SAME_PLANE ? root : face;
    }

    /** Component a of corner k of a face. */
    public float corner(int face, int k, int a) {
        return corner[9 * face + 3 * k + a];
    }

    /** Component a of corner k of a face, scene units. */
    double sceneCorner(int face, int k, int a) {
        Vec3 p = sceneCorner(face, k);
        return a == 0 ? p.x() : a == 1 ? p.y() : p.z();
    }

    /** Corner k of a face, scene units. */
    Vec3 sceneCorner(int face, int k) {
        return points.at(point[3 * face + k]);
    }

    /** Where a corner with this number lies, scene units. */
    Vec3 place(int number) {
        return points.at(number);
    }

    /** A face's normal as exactly as its corners tell. */
    Vec3 exactNormal(int face) {
        Vec3 a = sceneCorner(face, 0);
        return sceneCorner(face, 1).minus(a).cross(sceneCorner(face, 2).minus(a)).unit();
    }

    /** Lets some faces emit nothing, as their light would reach nobody. To be called before anything shines. */
    public void darken(IntPredicate hidden) {
        shine.darken(hidden);
    }

    /** Whether a face is a piece of a triangle that was cut: nothing stands on it or comes through, but at its border. */
    boolean isPiece(int face) {
        return piece[face];
    }

    /** E in W/m², in the mean over a face. */
    public double exitance(int face, int channel) {
        return shine.exitance(face, channel);
    }

    /** rho in [0, 1), in the mean over a face. */
    public double reflectance(int face, int channel) {
        return shine.reflectance(face, channel);
    }

    /** Whether a picture tells what is where on a face. */
    boolean isMapped(int face) {
        return shine.isMapped(face);
    }

    /** E in W/m², in the mean over a node. */
    public double exitance(int face, long path, int channel) {
        return shine.exitance(face, path, channel);
    }

    /** rho in [0, 1), in the mean over a node. */
    public double reflectance(int face, long path, int channel) {
        return shine.reflectance(face, path, channel);
    }

    /** How much irradiance on a face matters: its reflectance; a little where it is black, for it is a result too. */
    public double importance(int face, int channel) {
        return Math.max(LEAST_IMPORTANCE, shine.reflectance(face, channel));
    }

    /** Height over the longest edge, of the scene's size. */
    double height(int face) {
        double longest = 0;
        for (int k = 0; k < 3; k++) {
            double d2 = 0;
            for (int a = 0; a < 3; a++) {
                double d = (double) corner(face, k, a) - corner(face, (k + 1) % 3, a);
                d2 += d * d;
            }
            longest = Math.max(longest, d2);
        }
        return 2 * area[face] / Math.sqrt(longest);
    }

    /** All original triangles, small ones too, as corners for {@code RadiosityBounds}: 9 per triangle. */
    public float[] occluders() {
        float[] corners = new float[9 * scene.triangles()];
        for (int t = 0; t < scene.triangles(); t++) {
            for (int k = 0; k < 3; k++) {
                put(corners, 9 * t + 3 * k, unit(scene.corner(t, k)));
            }
        }
        return corners;
    }
}
