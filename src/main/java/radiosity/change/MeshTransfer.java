package radiosity.change;

import java.util.BitSet;
import java.util.function.IntToLongFunction;
import java.util.stream.IntStream;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.face.Subdivision;
import radiosity.partition.GhostVertices;
import radiosity.partition.MeshRefinement;
import radiosity.protocol.Order;
import radiosity.scene.Vec3;
import radiosity.setup.InitialMesh;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/**
 * Builds the mesh of a later scene from the elements of an earlier scene, and transfers the light of these elements.
 *
 * <p>Faces with the same corners keep their elements. Faces of unchanged triangles that are cut in other ways, because
 * another object stands on them, are divided about as finely as before and take the light found at the same positions.
 * Faces of new triangles have the elements of the initial mesh, without light.
 */
final class MeshTransfer {

    /** Split number where the earlier mesh was divided in its initial mesh, or was not divided at all. */
    private static final int SPLIT = 1;
    /** A later element is divided while it is larger by more than this factor than an earlier element within it. */
    private static final double SMALLER = 3;
    /** Light at a corner is looked up this part of the way from the corner to the middle of its element. */
    private static final double INSIDE = 1e-3;
    /** Group of faces that are gone, in which there are no faces of the later scene. */
    private static final long GONE = -2;

    final RadiosityNodes made;
    /** Vertices without any light of the earlier scene. */
    final BitSet fresh = new BitSet();
    /** Vertices of faces of unchanged triangles that are cut in another way than before. */
    final BitSet moved = new BitSet();
    /** Vertices that lay inside a solid in the earlier scene. */
    final BitSet wasBuried = new BitSet();

    private final RadiosityNodes old;
    private final MeshRefinement refinement;
    private final Faces before;
    private final Faces now;
    private final int channels;
    /** 1 per face of the later scene: the face of the earlier scene with the same corners, or -1. */
    private final int[] same;
    private final long[] groupsNow;
    private final FaceLocator earlier;
    private final FaceLocator later;
    /** Faces of unchanged triangles of the earlier scene that are cut in another way in the later scene. */
    private final int[] recut;
    private final long[] groupsBefore;
    private final BitSet known = new BitSet();

    /**
     * @param old   elements of the earlier scene, of all its blocks
     * @param rules refinement rules of the earlier scene
     */
    MeshTransfer(SceneChange change, RadiosityNodes old, Order.Rules rules, InitialMesh earlierMesh, InitialMesh mesh) {
        this.old = old;
        refinement = new MeshRefinement(old, new Weights(earlierMesh.rooms, old.channels(), rules.weight()),
                rules.meshError());
        before = old.faces();
        now = mesh.faces;
        channels = now.channels();
        made = new RadiosityNodes(mesh.patcher, mesh.blocks);
        groupsNow = change.groupsNow();
        groupsBefore = change.groupsBefore();
        boolean[] gone = change.goneFaces();
        same = SceneChange.twins(places(before, f -> gone[f] ? GONE : groupsBefore[f]),
                places(now, f -> groupsNow[f]));
        boolean[] kept = new boolean[before.count()];
        for (int f : same) {
            if (f >= 0) {
                kept[f] = true;
            }
        }
        recut = IntStream.range(0, kept.length).filter(f -> !kept[f] && !gone[f]).toArray();
        earlier = new FaceLocator(before, recut, groupsBefore);
        int[] others = IntStream.range(0, same.length).filter(f -> same[f] < 0 && groupsNow[f] >= 0).toArray();
        later = new FaceLocator(now, others, groupsNow);
        shape();
        for (int node = 0; node < made.nodes(); node++) {
            if (made.isElement(node)) {
                fill(node);
            }
        }
        alignCopies();
        fresh.set(0, made.vertices());
        fresh.andNot(known);
    }

    /** 1 per face: key of its corners, its side of the triangle, and its group. */
    private static long[] places(Faces faces, IntToLongFunction group) {
        long[] places = new long[faces.count()];
        for (int f = 0; f < places.length; f++) {
            places[f] = Hash.mix(group.applyAsLong(f), faces.side(f) & 1);
            for (int i = 0; i < 9; i++) {
                places[f] = Hash.mix(places[f], Float.floatToRawIntBits(faces.corner(f, i / 3, i % 3)));
            }
        }
        return places;
    }

    /*---- Division of elements ----*/

    private void shape() {
        made.beginSplits(old.elements() / 3);
        for (int top : made.tops()) {
            if (same[made.face(top)] >= 0) {
                shape(top, same[made.face(top)]);
            }
        }
        boolean[] wanted = new boolean[before.count()];
        for (int f : recut) {
            wanted[f] = true;
        }
        for (int node = 0; node < old.nodes(); node++) {
            boolean isWanted = wanted[old.face(node)];
            if (isWanted && (old.isElement(node) ? !isPartOfTooFine(node) : refinement.isTooFine(node))) {
                divideAround(node);
            }
        }
    }

    private boolean isPartOfTooFine(int element) {
        int parent = old.parent(element);
        return parent >= 0 && refinement.isTooFine(parent);
    }

    /** Divides a node as the node of the same path on an earlier face was divided. */
    private void shape(int node, int face) {
        long path = made.path(node);
        int twin = old.find(face, path);
        if (twin >= 0 ? old.isElement(twin) || refinement.isTooFine(twin) : !isAboveTops(face, path)) {
            return;
        }
        int first = made.isElement(node)
                ? made.split(node, twin < 0 ? SPLIT : Math.max(SPLIT, old.dividedWith(twin))) : made.child(node);
        for (int k = 0; k < 4; k++) {
            shape(first + k, face);
        }
    }

    /** Whether the nodes of an earlier face begin below this path. */
    private boolean isAboveTops(int face, long path) {
        for (long p = path; p >= NodePath.FACE; p >>= 2) {
            if (old.find(face, p) >= 0) {
                return false;
            }
        }
        return true;
    }

    /** Divides the later element that contains the middle of an earlier element until both are of similar size. */
    private void divideAround(int element) {
        Vec3[] corner = corners(old, element);
        Vec3 middle = corner[0].plus(corner[1]).plus(corner[2]).times(1.0 / 3);
        int f = old.face(element);
        FaceLocator.Place place = later.find(middle, before.exactNormal(f), groupsBefore[f]);
        if (place == null) {
            return;
        }
        long path = NodePath.FACE;
        double[] weights = place.weights();
        while (NodePath.level(path) < NodePath.MAX_LEVEL) {
            int node = made.find(place.face(), path);
            if (node >= 0 && made.isElement(node)) {
                if (made.area(node) <= SMALLER * old.area(element)) {
                    return;
                }
                made.split(node, SPLIT);
            }
            path = NodePath.child(path, Subdivision.enter(weights));
        }
    }

    private static Vec3[] corners(RadiosityNodes nodes, int node) {
        double[] at = new double[9];
        Vec3[] corner = new Vec3[3];
        for (int k = 0; k < 3; k++) {
            nodes.position(node, k, at, 3 * k);
            corner[k] = new Vec3(at[3 * k], at[3 * k + 1], at[3 * k + 2]);
        }
        return corner;
    }

    /*---- Light of the elements ----*/

    private void fill(int element) {
        int face = made.face(element);
        if (same[face] >= 0) {
            copy(element, same[face]);
        } else if (groupsNow[face] >= 0) {
            interpolate(element);
        }
    }

    /** Copies the light of the earlier element of the same path, of the element around it, or of its children. */
    private void copy(int element, int face) {
        long path = made.path(element);
        long at = path;
        int twin = old.find(face, at);
        while (twin < 0 && at > NodePath.FACE) {
            at >>= 2;
            twin = old.find(face, at);
        }
        if (twin < 0 || at != path && !old.isElement(twin)) {
            return;
        }
        double[] shot = new double[3 * channels];
        double[] arrived = new double[3 * channels];
        for (int i = 0; i < arrived.length; i++) {
            int part = twin;
            while (!old.isElement(part)) {
                part = old.child(part) + i / channels;
            }
            shot[i] = old.light().shot(part, i / channels, i % channels);
            arrived[i] = old.light().irradiance(part, i / channels, i % channels);
        }
        for (int level = NodePath.level(at) + 1; level <= NodePath.level(path); level++) {
            shot = Subdivision.values(shot, channels, NodePath.step(path, level));
            arrived = Subdivision.values(arrived, channels, NodePath.step(path, level));
        }
        for (int k = 0; k < 3; k++) {
            put(element, k, shot, arrived);
            if (at == path && old.points().isBuried(old.corner(twin, k))) {
                wasBuried.set(made.corner(element, k));
            }
        }
    }

    /**
     * @param arrived irradiance at the three corners; where elements share a vertex, the first element sets its
     *                irradiance
     */
    private void put(int element, int k, double[] shot, double[] arrived) {
        double[] irradiance = made.light().irradiance();
        int v = made.corner(element, k);
        for (int c = 0; c < channels; c++) {
            made.light().setShot(element, k, c, shot[channels * k + c]);
            if (!known.get(v)) {
                irradiance[channels * v + c] = made.isPoint(element)
                        ? (arrived[c] + arrived[channels + c] + arrived[2 * channels + c]) / 3
                        : arrived[channels * k + c];
            }
        }
        known.set(v);
    }

    /** Gives all vertices of a ghost key, which hosts gather only once, the irradiance of the first known vertex. */
    private void alignCopies() {
        LongIndex first = new LongIndex(known.cardinality());
        known.stream().forEach(v -> first.findOrAdd(GhostVertices.key(made, v), v));
        double[] irradiance = made.light().irradiance();
        for (int v = 0; v < made.vertices(); v++) {
            int from = first.find(GhostVertices.key(made, v));
            if (from >= 0 && from != v) {
                System.arraycopy(irradiance, channels * from, irradiance, channels * v, channels);
                known.set(v);
                wasBuried.set(v, wasBuried.get(from));
            }
        }
    }

    /** Takes over the earlier light found at the corners of an element. */
    private void interpolate(int element) {
        int face = made.face(element);
        Vec3[] corner = corners(made, element);
        Vec3 middle = corner[0].plus(corner[1]).plus(corner[2]).times(1.0 / 3);
        double[] shot = new double[3 * channels];
        double[] arrived = new double[3 * channels];
        boolean[] isFound = new boolean[3];
        for (int k = 0; k < 3; k++) {
            moved.set(made.corner(element, k));
            Vec3 p = corner[k].plus(middle.minus(corner[k]).times(INSIDE));
            isFound[k] = look(p, now.exactNormal(face), groupsNow[face], shot, arrived, channels * k);
        }
        for (int k = 0; k < 3; k++) {
            if (isFound[k]) {
                put(element, k, shot, arrived);
            }
        }
    }

    private boolean look(Vec3 p, Vec3 normal, long group, double[] shot, double[] arrived, int to) {
        FaceLocator.Place place = earlier.find(p, normal, group);
        if (place == null) {
            return false;
        }
        long path = NodePath.FACE;
        double[] weights = place.weights();
        int node = old.find(place.face(), path);
        while ((node < 0 || !old.isElement(node)) && NodePath.level(path) < NodePath.MAX_LEVEL) {
            path = NodePath.child(path, Subdivision.enter(weights));
            node = old.find(place.face(), path);
        }
        boolean isSeen = false;
        for (int k = 0; k < 3 && node >= 0; k++) {
            isSeen |= !old.points().isBuried(old.corner(node, k));
            for (int c = 0; c < channels; c++) {
                shot[to + c] += weights[k] * old.light().shot(node, k, c);
                arrived[to + c] += weights[k] * old.light().irradiance(node, k, c);
            }
        }
        return isSeen;
    }
}
