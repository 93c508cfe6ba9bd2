package radiosity.mesh.face;

import java.util.List;
import java.util.function.IntPredicate;
import radiosity.scene.Lamp;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.LongIndex;

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
    private final FaceList list;
    /** These six are the list's, for whoever reads one of them often. */
    private final int count;
    final int[] side;
    public final float[] corner;
    final float[] normal;
    final double[] area;
    public final int[] point;
    /** 1 per face: the lowest face of its part. */
    public final int[] part;
    /** 3 per face: which corners are one, as faces of a part lie all round between them: the lowest such corner. */
    public final int[] fan;
    /** 1 per face: bit k where the edge opposite corner k is the part's border. */
    public final byte[] border;
    private final FaceMaterials materials;

    /** All light of a scene as one. */
    public Faces(Scene scene) {
        this(scene, false);
    }

    /** @param layered whether the light of each lamp is kept apart: in channels of its own */
    public Faces(Scene scene, boolean layered) {
        this(scene, SceneBox.of(scene), new Channels(scene, layered));
    }

    private Faces(Scene scene, SceneBox box, Channels kinds) {
        this(scene, box, kinds, FaceList.of(scene, box), new LongIndex(0));
    }

    /** @param cut as {@link CoplanarRegions#join} has it */
    private Faces(Scene scene, SceneBox box, Channels kinds, FaceList list, LongIndex cut) {
        this.scene = scene;
        this.box = box;
        this.kinds = kinds;
        this.list = list;
        channels = kinds.colours * kinds.layers();
        count = list.count;
        side = list.side;
        corner = list.corner;
        normal = list.normal;
        area = list.area;
        point = list.point;
        part = new int[side.length];
        fan = new int[3 * side.length];
        border = new byte[side.length];
        new CoplanarRegions(this).join(cut);
        materials = new FaceMaterials(this, kinds);
    }

    /** The same scene with some faces replaced by their pieces. */
    public Faces withPieces(FacePieces pieces) {
        return new Faces(scene, box, kinds, list.withPieces(pieces), pieces.edges());
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
        return list.dropped;
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
        return kinds.isOf(false, light, channel) ? scene.lights().get(light).power().channel(channel % kinds.colours)
                : 0;
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
        return list.wholeArea;
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
    public double sceneCorner(int face, int k, int a) {
        return sceneCorner(face, k).coordinate(a);
    }

    /** Corner k of a face, scene units. */
    public Vec3 sceneCorner(int face, int k) {
        return list.points.at(point[3 * face + k]);
    }

    /** Where a corner with this number lies, scene units. */
    public Vec3 place(int number) {
        return list.points.at(number);
    }

    /** A face's normal as exactly as its corners give it. */
    public Vec3 exactNormal(int face) {
        Vec3 a = sceneCorner(face, 0);
        return sceneCorner(face, 1).minus(a).cross(sceneCorner(face, 2).minus(a)).unit();
    }

    /** Lets some faces emit nothing, as their light would reach nobody. To be called before anything is shot. */
    public void darken(IntPredicate hidden) {
        materials.darken(hidden);
    }

    /**
     * Whether a face is a piece of a triangle that was cut: nothing stands on it or comes through, but at its border.
     */
    public boolean isPiece(int face) {
        return list.piece[face];
    }

    /** E in W/m², in the mean over a face. */
    public double exitance(int face, int channel) {
        return materials.exitance(face, channel);
    }

    /** rho in [0, 1), in the mean over a face. */
    public double reflectance(int face, int channel) {
        return materials.reflectance(face, channel);
    }

    /** Whether a picture says what is where on a face. */
    public boolean isMapped(int face) {
        return materials.isMapped(face);
    }

    /** E in W/m², in the mean over a node. */
    public double exitance(int face, long path, int channel) {
        return materials.exitance(face, path, channel);
    }

    /** rho in [0, 1), in the mean over a node. */
    public double reflectance(int face, long path, int channel) {
        return materials.reflectance(face, path, channel);
    }

    /** How much irradiance on a face matters: its reflectance; a little where it is black, for it is a result too. */
    public double importance(int face, int channel) {
        return Math.max(LEAST_IMPORTANCE, materials.reflectance(face, channel));
    }

    /** Height over the longest edge, of the scene's size. */
    public double height(int face) {
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
                unit(scene.corner(t, k)).write(corners, 9 * t + 3 * k);
            }
        }
        return corners;
    }
}
