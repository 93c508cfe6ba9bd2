package radiosity.mesh.face;

import java.util.BitSet;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import radiosity.scene.Lamp;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/**
 * The radiating sides of the original triangles, brought to size 1 around the origin: the roots of the patch tree.
 *
 * <p>A two-sided triangle has two faces, any other triangle one. Triangles smaller than {@value #LEAST_AREA} squared
 * scene sizes have none. Faces of one surface that meet along edges in one plane form a <i>part</i>, or coplanar
 * region.
 */
public final class Faces {

    /** Least area of a face, in squared scene sizes. */
    public static final double LEAST_AREA = 1e-12;
    /** A point nearer to a plane or a line than this lies on it, in scene sizes. */
    public static final double NEAR = 1e-6;
    /**
     * Height up to which a face covers another face below that looks the same way, in scene sizes: there is no light
     * between them, as rays begin and end about as high above faces ({@code RadiosityBounds.LIFT}).
     */
    public static final double COVERING = 1e-5;
    /** Importance of irradiance on a black face. */
    public static final double LEAST_IMPORTANCE = 0.05;
    /** Largest difference between components of the normals of faces in one plane. */
    private static final float SAME_PLANE = 1e-5f;

    private final Scene scene;
    private final SceneBox box;
    private final Channels kinds;
    private final int channels;
    private final FaceList list;
    /** These six are fields of {@link #list}, repeated here for code that reads one of them often. */
    private final int count;
    final int[] side;
    public final float[] corner;
    final float[] normal;
    final double[] area;
    public final int[] point;
    /** 1 per face: the lowest face of its part. */
    public final int[] part;
    /** 3 per face: the lowest of the corners (3 * face + k) that faces of the part connect around one vertex. */
    public final int[] fan;
    /** 3 per face: the face of the same part beyond the edge opposite corner k; -1 on the border of the part. */
    public final int[] across;
    private final FaceMaterials materials;
    /** The triangles inside closed solids, which no light reaches. */
    private BitSet enclosed = new BitSet();
    /** 1 per face: area outside of solids that no other face covers, in squared scene sizes. */
    private double[] exposed;
    /** 1 per face: largest area that is inside solids or covered by other faces, in squared scene sizes. */
    private double[] hidden;

    /** Faces with the light of all lamps in the same channels. */
    public Faces(Scene scene) {
        this(scene, false);
    }

    /** @param layered whether the light of each lamp is kept in channels of its own */
    public Faces(Scene scene, boolean layered) {
        this(scene, SceneBox.of(scene), new Channels(scene, layered));
    }

    private Faces(Scene scene, SceneBox box, Channels kinds) {
        this(scene, box, kinds, FaceList.of(scene, box), new LongIndex(0));
    }

    /** @param cut edges that are borders of parts in any case, see {@link CoplanarRegions#join} */
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
        exposed = area;
        hidden = area;
        point = list.point;
        part = new int[side.length];
        fan = new int[3 * side.length];
        across = new int[3 * side.length];
        new CoplanarRegions(this).join(cut);
        materials = new FaceMaterials(this, kinds);
    }

    /** The same scene with some faces replaced by their pieces. */
    public Faces withPieces(FacePieces pieces) {
        return new Faces(scene, box, kinds, list.withPieces(pieces), pieces.edges());
    }

    /** Faces of the same scene without some of them; this object where there are none. */
    public Faces without(BitSet dropped) {
        return dropped.isEmpty() ? this : new Faces(scene, box, kinds, list.without(dropped), new LongIndex(0));
    }

    /** A point of the scene, brought to size 1 around the origin. */
    public Vec3 unit(Vec3 p) {
        return box.unit(p);
    }

    public int count() {
        return count;
    }

    /** Number of triangles that were too small to radiate. */
    public int dropped() {
        return list.dropped;
    }

    public Scene scene() {
        return scene;
    }

    /** Largest extent of the box around all triangles, scene units. */
    public double size() {
        return box.size();
    }

    /** Number of channels of the light: {@link #colours} times {@link #layers}, layer by layer. */
    public int channels() {
        return channels;
    }

    /** 1 where everything in the scene is grey, else 3. */
    public int colours() {
        return kinds.colours;
    }

    /** Number of lamps where the light of each is kept apart, else 1. */
    public int layers() {
        return kinds.layers();
    }

    /**
     * The sums over layers of values per channel.
     *
     * @return one value per colour; empty where {@code channels} is
     */
    public double[] perColour(double[] channels) {
        double[] sum = new double[Math.min(channels.length, kinds.colours)];
        for (int c = 0; c < channels.length; c++) {
            sum[c % sum.length] += channels[c];
        }
        return sum;
    }

    /** The lamps that have a layer each; empty where the light of all lamps is kept together. */
    public List<Lamp> lamps() {
        return kinds.lamps;
    }

    /** A light's {@link radiosity.scene.Light#power()} in a channel; 0 in the layers of other lamps. */
    public double power(int light, int channel) {
        return kinds.isOf(false, light, channel) ? scene.lights().get(light).power().channel(channel % kinds.colours)
                : 0;
    }

    /** 3 per original triangle: normal of its visible side; 0 where both sides are visible. */
    public float[] fronts() {
        float[] fronts = new float[3 * scene.triangles()];
        byte[] sides = new byte[scene.triangles()];
        for (int f = 0; f < count; f++) {
            sides[triangle(f)] |= (byte) (1 << (side[f] & 1));
        }
        for (int f = 0; f < count; f++) {
            for (int a = 0; a < 3 && sides[triangle(f)] < 3; a++) {
                fronts[3 * triangle(f) + a] = normal(f, a);
            }
        }
        return fronts;
    }

    /**
     * The corners of a node.
     *
     * @param path of the node below the face, see {@link NodePath}
     * @return x, y, z of three corners, in the scene brought to size 1
     */
    public float[] corners(int face, long path) {
        float[] at = new float[9];
        for (int i = 0; i < 9; i++) {
            at[i] = corner(face, i / 3, i % 3);
        }
        for (int level = 1; level <= NodePath.level(path); level++) {
            Subdivision.descend(at, NodePath.step(path, level));
        }
        return at;
    }

    /** The original triangle of a face. */
    public int triangle(int face) {
        return side[face] >> 1;
    }

    /** 2 * original triangle, + 1 for the back. */
    public int side(int face) {
        return side[face];
    }

    /** Area of a face, in squared scene sizes. */
    public double area(int face) {
        return area[face];
    }

    /**
     * Area of a face outside of solids that no other face in the same place covers, in squared scene sizes: light
     * arrives on this area and leaves it.
     */
    public double exposedArea(int face) {
        return exposed[face];
    }

    /**
     * Largest area of a face that lies inside solids or is covered by other faces in the same place, in squared scene
     * sizes: all of the face where the hidden area was not estimated.
     */
    public double mostHiddenArea(int face) {
        return hidden[face];
    }

    /** @param triangles those inside closed solids, which are no occluders as no light reaches them; kept */
    public void enclose(BitSet triangles) {
        enclosed = triangles;
    }

    /** @param visible share of a face outside of solids that no other face covers, from 0 to 1; NaN where unknown */
    public void cover(IntToDoubleFunction visible) {
        exposed = area.clone();
        hidden = area.clone();
        for (int f = 0; f < count; f++) {
            double share = visible.applyAsDouble(f);
            if (!Double.isNaN(share)) {
                exposed[f] = area[f] * share;
                hidden[f] = area[f] - exposed[f];
            }
        }
    }

    /** Area of a node at a path below a face, in squared scene sizes. */
    public double area(int face, long path) {
        return area[face] / (1L << 2 * NodePath.level(path));
    }

    /** The {@linkplain #exposedArea(int) exposed area} of a face times the share of the face that a node has. */
    public double exposedArea(int face, long path) {
        return exposed[face] / (1L << 2 * NodePath.level(path));
    }

    /** Area of all faces, in squared scene sizes. */
    public double area() {
        return list.wholeArea;
    }

    /** Component a of a face's normal. */
    public float normal(int face, int a) {
        return normal[3 * face + a];
    }

    /**
     * The face whose plane is used for a face's vertices: the lowest of its part, so that a vertex lies in the same
     * plane for all faces that share it; the face itself where its normal differs too much from the lowest face's.
     */
    public int plane(int face) {
        int root = part[face];
        float off = 0;
        for (int a = 0; a < 3; a++) {
            off = Math.max(off, Math.abs(normal[3 * root + a] - normal[3 * face + a]));
        }
        return off < SAME_PLANE ? root : face;
    }

    /** The centroid of a face, x, y, z in the scene brought to size 1. */
    public float[] middle(int face) {
        float[] middle = new float[3];
        for (int a = 0; a < 3; a++) {
            middle[a] = (corner(face, 0, a) + corner(face, 1, a) + corner(face, 2, a)) / 3;
        }
        return middle;
    }

    /** Component a of corner k of a face, in the scene brought to size 1. */
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

    /** Position of the point with a number, scene units; see {@link #point}. */
    public Vec3 place(int number) {
        return list.points.at(number);
    }

    /** Corner k of a face, from 0 to 2, in the scene brought to size 1. */
    public Vec3 unitCorner(int face, int k) {
        return new Vec3(corner(face, k, 0), corner(face, k, 1), corner(face, k, 2));
    }

    /** A face's normal, of length 1 but for the rounding of its components to floats. */
    public Vec3 unitNormal(int face) {
        return new Vec3(normal(face, 0), normal(face, 1), normal(face, 2));
    }

    /** A face's unit normal in double precision, from its corners. */
    public Vec3 exactNormal(int face) {
        Vec3 a = sceneCorner(face, 0);
        return sceneCorner(face, 1).minus(a).cross(sceneCorner(face, 2).minus(a)).unit();
    }

    /** Sets the exitance of hidden faces to 0, as their light would reach no face. Must be called before any shot. */
    public void darken(IntPredicate hidden) {
        materials.darken(hidden);
    }

    /** Whether the edge of a face opposite corner k, from 0 to 2, is on the border of the face's part. */
    public boolean isBorder(int face, int k) {
        return across[3 * face + k] < 0;
    }

    /** Whether a face is a piece of a cut triangle: other triangles stand on or pass through only a piece's border. */
    public boolean isPiece(int face) {
        return list.piece[face];
    }

    /** Whether a face emits light in any channel. */
    public boolean emits(int face) {
        for (int c = 0; c < channels; c++) {
            if (exitance(face, c) > 0) {
                return true;
            }
        }
        return false;
    }

    /** Exitance E, mean over a face, W/m². */
    public double exitance(int face, int channel) {
        return materials.exitance(face, channel);
    }

    /** Reflectance rho, mean over a face, in [0, 1). */
    public double reflectance(int face, int channel) {
        return materials.reflectance(face, channel);
    }

    /** Whether exitance or reflectance vary on a face. */
    public boolean isMapped(int face) {
        return materials.isMapped(face);
    }

    /** Exitance E, mean over a node, W/m². */
    public double exitance(int face, long path, int channel) {
        return materials.exitance(face, path, channel);
    }

    /** Reflectance rho, mean over a node, in [0, 1). */
    public double reflectance(int face, long path, int channel) {
        return materials.reflectance(face, path, channel);
    }

    /**
     * Mixes into a digest what the vertices of a face and the light on it depend on besides the corners: the side, the
     * coplanar region and the fans whose vertices the face shares, exitance and reflectance.
     */
    public long digest(long before, int face) {
        long digest = Hash.mix(Hash.mix(before, side[face]), part[face]);
        for (int k = 0; k < 3; k++) {
            digest = Hash.mix(digest, fan[3 * face + k]);
        }
        return materials.digest(digest, face);
    }

    /** Weight of irradiance on a face: the reflectance, but not below a minimum, as irradiance is a result, too. */
    public double importance(int face, int channel) {
        return Math.max(LEAST_IMPORTANCE, materials.reflectance(face, channel));
    }

    /** Height of a face over its longest edge, in scene sizes. */
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

    /**
     * The corners of all original triangles, including small ones, for {@code RadiosityBounds}: 9 per triangle. Those
     * of an enclosed triangle are all its first corner, so that no ray meets the triangle.
     */
    public float[] occluders() {
        float[] corners = new float[9 * scene.triangles()];
        for (int t = 0; t < scene.triangles(); t++) {
            for (int k = 0; k < 3; k++) {
                unit(scene.corner(t, enclosed.get(t) ? 0 : k)).write(corners, 9 * t + 3 * k);
            }
        }
        return corners;
    }
}
