package radiosity.input.assembly;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.MemoryAdvice;
import radiosity.scene.Camera;
import radiosity.scene.Hierarchy;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;
import radiosity.util.Aabb;

/** Collects a scene while a reader reads it: the nodes of the hierarchy, and instances of meshes at the nodes. */
public final class SceneDraft {

    /** Largest number of nodes of a scene: the heap size divided by 1 KiB. */
    public static final long MOST_NODES = Runtime.getRuntime().maxMemory() >> 10;

    /** Memory per triangle, per triangle with vertex colours in addition, and per point of a scene, bytes. */
    private static final int TRIANGLE_BYTES = 20 + 24;
    private static final int COLOUR_BYTES = 36;
    private static final int POINT_BYTES = 24;
    /** Additional memory per point while equal points are merged, bytes. */
    private static final int SHARED_POINT_BYTES = 24 + 4 + 4 + 48;
    /** Upper bound of coordinates: the squares of areas, which are of the fourth power, must not overflow. */
    private static final double FARTHEST = 1e70;

    /** Least distance of neighbouring floats at a mesh's place / size of the scene of which the user is warned. */
    private static final double COARSE = 1e-4;

    private final String name;
    private final ReadOptions options;
    private final Diagnostics notes;
    private final List<SceneNode> nodes = new ArrayList<>();
    private final List<Instance> instances = new ArrayList<>();
    private long triangles;
    private long points;
    private final boolean shared;
    private boolean textured;
    private boolean coloured;
    /** Largest distance, in the scene, of neighbouring floats at the place of a mesh in its own space. */
    private double coarseness;

    private record Instance(TriangleMesh mesh, Placing placing, int[] surfaces, int node) { }

    /**
     * @param name   of the scene
     * @param shared whether points at equal places are merged, as for a format that repeats points for the sake of
     *               textures
     */
    public SceneDraft(String name, boolean shared, ReadOptions options, Diagnostics notes) {
        this.shared = shared;
        this.name = name;
        this.options = options;
        this.notes = notes;
    }

    /**
     * Adds a node, whose parent has been added already.
     *
     * @param place place of the node in the file, for messages
     * @return index of the node
     * @throws SceneFormatException where there are more nodes than memory allows
     */
    public int node(SceneNode node, String place) throws SceneFormatException {
        if (nodes.size() >= MOST_NODES) {
            throw notes.error(place, "at most " + MOST_NODES + " objects and instances ("
                    + MemoryAdvice.forBytes(0) + ")", "more");
        }
        nodes.add(node);
        return nodes.size() - 1;
    }

    /**
     * Adds an instance of a mesh; an instance whose coordinates would be too large is left out with a note.
     *
     * @param surfaces index in the scene of each of the mesh's surfaces; not modified
     * @param node     index of the node to which the instance belongs
     * @param place    place of the instance in the file, for messages
     * @throws SceneFormatException where the scene has more triangles than the options or memory allow
     */
    public void add(TriangleMesh mesh, Placing placing, int[] surfaces, int node, String place)
            throws SceneFormatException {
        float[] farthest = new float[3];
        for (int i = 0; i < mesh.points().length; i++) {
            farthest[i % 3] = Math.max(farthest[i % 3], Math.abs(mesh.points()[i]));
        }
        double reach = Math.max(farthest[0], Math.max(farthest[1], farthest[2]));
        double factor = 0;
        for (double m : placing.world().m()) {
            factor += Math.abs(m);
        }
        if (!(factor * Math.max(1, reach) < FARTHEST)) {
            notes.note(place, "objects too large or too far away for their numbers are left out",
                    nodes.get(node).geometry());
            return;
        }
        textured |= mesh.textureCoordinates().length > 0;
        coloured |= mesh.colours().length > 0;
        for (int k = 0; k < 3; k++) {
            double[] m = placing.world().m();
            coarseness = Math.max(coarseness, Math.ulp(farthest[k]) * new Vec3(m[k], m[4 + k], m[8 + k]).length());
        }
        reserve(mesh.triangles(), mesh.pointCount());
        instances.add(new Instance(mesh, placing, surfaces, node));
    }

    /**
     * Adds to the numbers of triangles and points.
     *
     * @throws SceneFormatException where the scene has more than the options or memory allow
     */
    private void reserve(int moreTriangles, int morePoints) throws SceneFormatException {
        triangles += moreTriangles;
        points += morePoints;
        if (triangles > options.maxTriangles() || points > Integer.MAX_VALUE / 3 - 8) {
            throw notes.error("", "at most " + options.maxTriangles() + " triangles", String.valueOf(triangles));
        }
        long each = TRIANGLE_BYTES + (coloured ? COLOUR_BYTES : 0);
        long eachPoint = shared ? POINT_BYTES + SHARED_POINT_BYTES : POINT_BYTES;
        long bytes = triangles * each + points * eachPoint;
        if (bytes > Runtime.getRuntime().maxMemory() / 2) {
            throw notes.error("", "a scene that fits in half of " + (Runtime.getRuntime().maxMemory() >> 20) + " MiB ("
                    + MemoryAdvice.forBytes(2 * bytes) + ")",
                    triangles + " triangles of " + points + " points");
        }
    }

    /**
     * Places all instances.
     *
     * @throws SceneFormatException where the scene has no triangle, or under {@code strict} at the first note
     */
    public Scene scene(List<Surface> surfaces, List<Light> lights, Optional<Camera> camera)
            throws SceneFormatException {
        PlacedTriangles placed = new PlacedTriangles((int) points, (int) triangles, textured, coloured);
        for (Instance instance : instances) {
            placed.add(instance.mesh, instance.placing, instance.surfaces, instance.node);
        }
        if (shared) {
            placed.shareEqualPoints();
        }
        if (placed.flat() > 0) {
            notes.note("", "triangles without area where they are placed are left out", placed.flat() + " triangles");
        }
        double size = placed.surfaceOf().length == 0 ? 0 : Aabb.of(placed.points()).diagonal();
        if (size > 0 && coarseness > COARSE * size) {
            notes.note("", String.format(Locale.ROOT, "coordinates are as coarse as %.2g of the scene's size; move the"
                    + " model to the origin before it is written as floats", coarseness / size));
        }
        notes.flush();
        if (placed.surfaceOf().length == 0) {
            throw notes.error("", "at least one polygon with an area", "none");
        }
        return new Scene(name, placed.points(), placed.corners(), placed.surfaceOf(), surfaces, lights, camera,
                placed.textureCoordinates(), placed.colours(), new Hierarchy(nodes, placed.nodeOf()));
    }
}
