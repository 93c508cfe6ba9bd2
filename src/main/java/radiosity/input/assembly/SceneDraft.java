package radiosity.input.assembly;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import radiosity.input.file.Diagnostics;
import radiosity.scene.Camera;
import radiosity.scene.Hierarchy;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;

/** A scene while it is read: nodes of its hierarchy, and meshes that stand there. */
public final class SceneDraft {

    /** A scene has no more nodes than this: memory divided by 1 KiB. */
    public static final long MOST_NODES = Runtime.getRuntime().maxMemory() >> 10;

    /** Memory that one triangle and one point take in a scene, bytes. */
    private static final int TRIANGLE_BYTES = 20 + 24;
    private static final int COLOUR_BYTES = 36;
    private static final int POINT_BYTES = 24;
    /** And while equal points are found. */
    private static final int SHARED_POINT_BYTES = 24 + 4 + 4 + 48;
    /** Coordinates beyond this lose their squares. */
    private static final double FARTHEST = 1e70;

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

    private record Instance(TriangleMesh mesh, Placing placing, int[] surfaces, int node) { }

    /**
     * @param name   of the scene
     * @param shared whether equal places are one point, as where a format repeats points for the sake of textures
     */
    public SceneDraft(String name, boolean shared, ReadOptions options, Diagnostics notes) {
        this.shared = shared;
        this.name = name;
        this.options = options;
        this.notes = notes;
    }

    /**
     * Adds a node, whose parent has been added.
     *
     * @param place where in the file it is, for messages
     * @return its index
     * @throws SceneFormatException where there are more than memory is for
     */
    public int node(SceneNode node, String place) throws SceneFormatException {
        if (nodes.size() >= MOST_NODES) {
            throw notes.error(place, "at most " + MOST_NODES + " objects and instances", "more");
        }
        nodes.add(node);
        return nodes.size() - 1;
    }

    /** The nodes so far. */
    public List<SceneNode> nodes() {
        return List.copyOf(nodes);
    }

    /**
     * Adds an instance of a mesh; it is left out, with a note, where its numbers would be too large.
     *
     * @param surfaces the scene's number of each of the mesh's surfaces; not modified
     * @param node     whose it is
     * @param place    where in the file it is, for messages
     * @throws SceneFormatException where the scene has more triangles than it may have, or than memory is for
     */
    public void add(TriangleMesh mesh, Placing placing, int[] surfaces, int node, String place)
            throws SceneFormatException {
        double reach = 0;
        for (float x : mesh.points()) {
            reach = Math.max(reach, Math.abs(x));
        }
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
        reserve(mesh.triangles(), mesh.pointCount());
        instances.add(new Instance(mesh, placing, surfaces, node));
    }

    /**
     * Checks that a scene may have this number of triangles and points more than before.
     *
     * @throws SceneFormatException where it may not
     */
    private void reserve(int moreTriangles, int morePoints) throws SceneFormatException {
        triangles += moreTriangles;
        points += morePoints;
        if (triangles > options.maxTriangles() || points > Integer.MAX_VALUE / 3 - 8) {
            throw notes.error("", "at most " + options.maxTriangles() + " triangles", String.valueOf(triangles));
        }
        long each = TRIANGLE_BYTES + (coloured ? COLOUR_BYTES : 0);
        long eachPoint = shared ? POINT_BYTES + SHARED_POINT_BYTES : POINT_BYTES;
        if (triangles * each + points * eachPoint > Runtime.getRuntime().maxMemory() / 2) {
            throw notes.error("", "a scene that fits in half of " + (Runtime.getRuntime().maxMemory() >> 20) + " MiB",
                    triangles + " triangles of " + points + " points");
        }
    }

    /**
     * Places all instances.
     *
     * @throws SceneFormatException if there is no triangle, or under {@code strict} at the first note
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
        notes.flush();
        if (placed.surfaceOf().length == 0) {
            throw notes.error("", "at least one polygon with an area", "none");
        }
        return new Scene(name, placed.points(), placed.corners(), placed.surfaceOf(), surfaces, lights, camera,
                placed.textureCoordinates(), placed.colours(), new Hierarchy(nodes, placed.nodeOf()));
    }
}
