package radiosity.input.assembly;

import java.lang.reflect.Array;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import radiosity.scene.Hierarchy;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;

/** Leaves surfaces and objects out of a scene: panes that would keep daylight out, a wall in the way of the view. */
public final class LeftOut {

    /** Largest number of names in a message. */
    private static final int MOST_NAMED = 20;

    private LeftOut() { }

    /**
     * The scene without the triangles of some surfaces and objects, and without the points that only these have. The
     * surfaces and nodes themselves stay, and so does the order of triangles and points.
     *
     * @param names of surfaces, or of objects, which are left out with all objects below them
     * @return the scene itself without names
     * @throws SceneFormatException where nothing has a name, or no triangle would remain
     */
    public static Scene of(Scene scene, Set<String> names) throws SceneFormatException {
        if (names.isEmpty()) {
            return scene;
        }
        Hierarchy hierarchy = scene.hierarchy();
        List<SceneNode> nodes = hierarchy.nodes();
        boolean[] nodeOut = new boolean[nodes.size()];
        Set<String> missing = new TreeSet<>(names);
        for (int n = 0; n < nodeOut.length; n++) {
            SceneNode node = nodes.get(n);
            nodeOut[n] = names.contains(node.name()) || node.parent() >= 0 && nodeOut[node.parent()];
            missing.remove(node.name());
        }
        int[] kept = IntStream.range(0, scene.triangles()).filter(t -> {
            String surface = scene.surface(t).name();
            missing.remove(surface);
            return !names.contains(surface) && (nodeOut.length == 0 || !nodeOut[hierarchy.of(t)]);
        }).toArray();
        if (!missing.isEmpty()) {
            throw new SceneFormatException(scene.name(), "", "a surface or an object that is called "
                    + missing.iterator().next() + " (--leave-out)", namesOf(scene));
        }
        if (kept.length == 0) {
            throw new SceneFormatException(scene.name(), "", "triangles that --leave-out does not name", "none");
        }
        return keep(scene, kept);
    }

    private static String namesOf(Scene scene) {
        Set<String> names = new LinkedHashSet<>();
        Arrays.stream(scene.surfaceOf()).distinct().forEach(s -> names.add(scene.surfaces().get(s).name()));
        scene.hierarchy().nodes().forEach(node -> names.add(node.name()));
        names.remove("");
        return names.stream().limit(MOST_NAMED).collect(Collectors.joining(", ", "",
                names.size() > MOST_NAMED ? ", and others" : ""));
    }

    private static Scene keep(Scene scene, int[] triangles) {
        BitSet used = new BitSet();
        for (int t : triangles) {
            for (int k = 0; k < 3; k++) {
                used.set(scene.corners()[3 * t + k]);
            }
        }
        int[] points = used.stream().toArray();
        int[] number = new int[scene.points().length / 3];
        for (int i = 0; i < points.length; i++) {
            number[points[i]] = i;
        }
        double[] places = new double[3 * points.length];
        copy(scene.points(), points, 3, places);
        int[] corners = new int[3 * triangles.length];
        copy(scene.corners(), triangles, 3, corners);
        Arrays.setAll(corners, i -> number[corners[i]]);
        int[] surfaceOf = Arrays.stream(triangles).map(t -> scene.surfaceOf()[t]).toArray();
        float[] coordinates = new float[scene.textureCoordinates().length == 0 ? 0 : 6 * triangles.length];
        copy(scene.textureCoordinates(), triangles, 6, coordinates);
        float[] colours = new float[scene.vertexColours().length == 0 ? 0 : 9 * triangles.length];
        copy(scene.vertexColours(), triangles, 9, colours);
        Hierarchy all = scene.hierarchy();
        Hierarchy hierarchy = all.nodes().isEmpty() ? all
                : new Hierarchy(all.nodes(), Arrays.stream(triangles).map(all::of).toArray());
        return new Scene(scene.name(), places, corners, surfaceOf, scene.surfaces(), scene.lights(), scene.camera(),
                coordinates, colours, hierarchy, scene.units());
    }

    /** Copies the values of some items, a number of values per item; nothing where the target is empty. */
    private static void copy(Object from, int[] items, int values, Object to) {
        for (int i = 0; i < items.length && Array.getLength(to) > 0; i++) {
            System.arraycopy(from, values * items[i], to, values * i, values);
        }
    }
}
