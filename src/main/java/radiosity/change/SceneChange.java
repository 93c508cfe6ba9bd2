package radiosity.change;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import radiosity.mesh.face.Faces;
import radiosity.protocol.SceneBytes;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.setup.InitialMesh;
import radiosity.util.Aabb;
import radiosity.util.Hash;

/**
 * Finds the triangles that are gone in a later scene and those that have come: triangles without a twin, of the same
 * corners and as many visible sides, in the other scene. Reflectance and exitance do not matter.
 *
 * <p>Where long quadrangles of an object's surface are cut into pieces, and one triangle of this surface and object has
 * changed, all triangles of this surface and object count as gone and come, as a piece may lie on two triangles.
 */
public final class SceneChange {

    /** Most objects that have boxes of their own; more objects share one box. */
    private static final int MOST_BOXES = 32;

    private final InitialMesh before;
    private final InitialMesh now;
    /** 1 per triangle of the scene with cut quadrangles: the original triangle, see {@link InitialMesh#origins}. */
    private final int[] originBefore;
    private final int[] originNow;
    /** 1 per original triangle of the later scene: its twin in the earlier scene, or -1. */
    private final int[] twin;
    /** 1 per original triangle of the earlier scene: whether the later scene has no twin. */
    private final boolean[] gone;

    public SceneChange(InitialMesh before, InitialMesh now) {
        this.before = before;
        this.now = now;
        originBefore = before.origins;
        originNow = now.origins;
        twin = twins(places(before.original), places(now.original));
        gone = new boolean[before.original.triangles()];
        mark();
        Set<Long> tornBefore = torn(before.original, originBefore, t -> gone[t]);
        Set<Long> tornNow = torn(now.original, originNow, t -> twin[t] < 0);
        for (int t = 0; t < twin.length; t++) {
            if (twin[t] >= 0 && (tornNow.contains(group(now.original, t))
                    || tornBefore.contains(group(before.original, twin[t])))) {
                twin[t] = -1;
            }
        }
        mark();
    }

    private void mark() {
        Arrays.fill(gone, true);
        for (int t : twin) {
            if (t >= 0) {
                gone[t] = false;
            }
        }
    }

    /**
     * Pairs triangles, or faces, of two scenes by their keys; each belongs to at most one pair.
     *
     * @param earlier 1 per triangle of the earlier scene: its key
     * @return 1 per triangle of the later scene: the first triangle of the same key that is left, or -1
     */
    static int[] twins(long[] earlier, long[] later) {
        Map<Long, Deque<Integer>> ofKey = new HashMap<>();
        for (int i = 0; i < earlier.length; i++) {
            ofKey.computeIfAbsent(earlier[i], key -> new ArrayDeque<>()).add(i);
        }
        int[] twin = new int[later.length];
        for (int i = 0; i < twin.length; i++) {
            Deque<Integer> same = ofKey.get(later[i]);
            twin[i] = same == null || same.isEmpty() ? -1 : same.remove();
        }
        return twin;
    }

    /** 1 per triangle: key of its corners and the number of its visible sides. */
    private static long[] places(Scene scene) {
        long[] places = new long[scene.triangles()];
        for (int t = 0; t < places.length; t++) {
            places[t] = scene.surface(t).twoSided() ? 1 : 2;
            for (int i = 0; i < 9; i++) {
                places[t] = Hash.mix(places[t], Double.doubleToLongBits(scene.corner(t, i / 3).coordinate(i % 3)));
            }
        }
        return places;
    }

    /** Key of the object and surface of a triangle. */
    private static long group(Scene scene, int t) {
        return (long) scene.hierarchy().of(t) << 32 | scene.surfaceOf()[t];
    }

    /** Returns the keys of objects' surfaces that have cut quadrangles and changed triangles. */
    private static Set<Long> torn(Scene scene, int[] origin, IntPredicate isChanged) {
        Set<Long> cut = new HashSet<>();
        int[] pieces = new int[scene.triangles()];
        for (int t : origin) {
            pieces[t]++;
        }
        for (int t = 0; t < pieces.length; t++) {
            if (pieces[t] != 1) {
                cut.add(group(scene, t));
            }
        }
        Set<Long> torn = new HashSet<>();
        for (int t = 0; t < pieces.length; t++) {
            if (isChanged.test(t) && cut.contains(group(scene, t))) {
                torn.add(group(scene, t));
            }
        }
        return torn;
    }

    /** Whether any triangle has come or gone. */
    public boolean isOfGeometry() {
        return share() > 0;
    }

    /** Returns the larger of two shares: area gone in the earlier scene's area, area come in the later scene's. */
    public double share() {
        return Math.max(share(before.original, t -> gone[t]), share(now.original, t -> twin[t] < 0));
    }

    private static double share(Scene scene, IntPredicate wanted) {
        double sum = 0;
        for (int t = 0; t < scene.triangles(); t++) {
            sum += wanted.test(t) ? Math.max(scene.area(t), Double.MIN_NORMAL) : 0;
        }
        return sum == 0 ? 0 : sum / Math.max(scene.area(), sum);
    }

    /** Whether sources without geometry differ. */
    public boolean isOfLights() {
        return !Arrays.equals(lights(before), lights(now));
    }

    /** Encodes the light sources of a scene, without their names. */
    private static byte[] lights(InitialMesh mesh) {
        return SceneBytes.write(new Scene("", new double[0], new int[0], new int[0], List.of(),
                mesh.original.lights(), Optional.empty()), mesh.settings);
    }

    /** 1 per face of the earlier scene: whether its triangle is gone. */
    boolean[] goneFaces() {
        boolean[] faces = new boolean[before.faces.count()];
        for (int f = 0; f < faces.length; f++) {
            faces[f] = gone[originBefore[before.faces.triangle(f)]];
        }
        return faces;
    }

    /** 1 per face of the later scene: group of its twin in the earlier scene, or -1 where the face has come. */
    long[] groupsNow() {
        long[] groups = new long[now.faces.count()];
        for (int f = 0; f < groups.length; f++) {
            int t = twin[originNow[now.faces.triangle(f)]];
            groups[f] = t < 0 ? -1 : group(before.original, t) & Long.MAX_VALUE;
        }
        return groups;
    }

    /** 1 per face of the earlier scene: key of its object and surface, at least 0. */
    long[] groupsBefore() {
        long[] groups = new long[before.faces.count()];
        for (int f = 0; f < groups.length; f++) {
            groups[f] = group(before.original, originBefore[before.faces.triangle(f)]) & Long.MAX_VALUE;
        }
        return groups;
    }

    /** Corners of triangles that are gone, in coordinates of the scene scaled to size 1, 9 per triangle. */
    float[] goneCorners() {
        return corners(before.original, t -> gone[t]);
    }

    /** Corners of triangles that have come, in coordinates of the scene scaled to size 1, 9 per triangle. */
    float[] comeCorners() {
        return corners(now.original, t -> twin[t] < 0);
    }

    private float[] corners(Scene scene, IntPredicate wanted) {
        List<Vec3> found = new ArrayList<>();
        Faces faces = now.faces;
        for (int t = 0; t < scene.triangles(); t++) {
            for (int k = 0; k < 3 && wanted.test(t); k++) {
                found.add(faces.unit(scene.corner(t, k)));
            }
        }
        float[] corners = new float[3 * found.size()];
        for (int i = 0; i < found.size(); i++) {
            found.get(i).write(corners, 3 * i);
        }
        return corners;
    }

    /** Boxes around the triangles gone and come, one per object, in coordinates of the scene scaled to size 1. */
    List<Aabb> boxes() {
        List<Aabb> boxes = new ArrayList<>(boxes(before.original, t -> gone[t]).values());
        boxes.addAll(boxes(now.original, t -> twin[t] < 0).values());
        return boxes.size() <= MOST_BOXES ? boxes : List.of(boxes.stream().reduce(Aabb::with).orElseThrow());
    }

    private Map<Integer, Aabb> boxes(Scene scene, IntPredicate wanted) {
        Map<Integer, Aabb> boxes = new TreeMap<>();
        for (int t = 0; t < scene.triangles(); t++) {
            for (int k = 0; k < 3 && wanted.test(t); k++) {
                Vec3 p = now.faces.unit(scene.corner(t, k));
                boxes.merge(scene.hierarchy().of(t), new Aabb(p, p), Aabb::with);
            }
        }
        return boxes;
    }
}
