package radiosity.input.gltf;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.gltf.JsonCursor;
import radiosity.scene.Affine;
import radiosity.scene.SceneFormatException;

/** The nodes of the default scene, each after its parent, with their placements. */
final class Nodes {

    /**
     * A node with its placement.
     *
     * @param number index of the node in the file
     * @param parent index of its parent among the placed nodes, or -1
     * @param local  map from the node's space to its parent's
     * @param world  map from the node's space to the scene's
     */
    record Placed(JsonCursor node, int number, int parent, Affine local, Affine world) { }

    private final JsonCursor root;
    private final List<Placed> nodes = new ArrayList<>();
    /** By the nodes' index in the file. */
    private final Map<Integer, Placed> byNumber = new HashMap<>();

    Nodes(JsonCursor root) throws SceneFormatException {
        this.root = root;
        collect();
    }

    List<Placed> all() {
        return nodes;
    }

    /** Map from a node's space to the scene's; empty where the node is not in the default scene. */
    Optional<Affine> world(int number) {
        return Optional.ofNullable(byNumber.get(number)).map(Placed::world);
    }

    /**
     * Numbers of the root nodes of the default scene: of the scene that the file names as default, else of the first.
     * Of a file without scenes, a library of parts, the nodes that are no node's children.
     */
    private int[] top() throws SceneFormatException {
        if (root.optional("scenes").isEmpty()) {
            return roots();
        }
        return numbers(root.at("scenes").at(Math.max(0, root.index("scene"))).optional("nodes"));
    }

    private int[] roots() throws SceneFormatException {
        Optional<JsonCursor> all = root.optional("nodes");
        BitSet found = new BitSet();
        found.set(0, all.map(JsonCursor::size).orElse(0));
        for (int i = 0; all.isPresent() && i < all.get().size(); i++) {
            for (int child : numbers(all.get().at(i).optional("children"))) {
                found.clear(child);
            }
        }
        return found.stream().toArray();
    }

    private static int[] numbers(Optional<JsonCursor> list) throws SceneFormatException {
        int[] numbers = new int[list.map(JsonCursor::size).orElse(0)];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = list.get().at(i).integer();
        }
        return numbers;
    }

    private record Ahead(int number, int parent) { }

    private void collect() throws SceneFormatException {
        Deque<Ahead> ahead = new ArrayDeque<>();
        int[] top = top();
        for (int i = top.length - 1; i >= 0; i--) {
            ahead.push(new Ahead(top[i], -1));
        }
        while (!ahead.isEmpty()) {
            Ahead next = ahead.pop();
            JsonCursor node = root.at("nodes").at(next.number);
            Affine local = local(node);
            Affine world = next.parent < 0 ? local : nodes.get(next.parent).world.times(local);
            Placed placed = new Placed(node, next.number, next.parent, local, world);
            if (byNumber.put(next.number, placed) != null) {
                throw new SceneFormatException(root.file(), "JSON " + node.path(), "a node with one parent", "several");
            }
            nodes.add(placed);
            int[] children = numbers(node.optional("children"));
            for (int i = children.length - 1; i >= 0; i--) {
                ahead.push(new Ahead(children[i], nodes.size() - 1));
            }
        }
    }

    private static Affine local(JsonCursor node) throws SceneFormatException {
        Optional<JsonCursor> matrix = node.optional("matrix");
        if (matrix.isPresent()) {
            return columns(matrix.get().numbers(16));
        }
        return of(node.numbers("translation", 0, 0, 0), node.numbers("rotation", 0, 0, 0, 1),
                node.numbers("scale", 1, 1, 1));
    }

    /** The map of a 4 x 4 matrix of 16 numbers column by column, whose last row is ignored. */
    static Affine columns(double[] numbers) {
        double[] m = new double[12];
        for (int i = 0; i < m.length; i++) {
            m[i] = numbers[4 * (i % 4) + i / 4];
        }
        return new Affine(m);
    }

    /**
     * The map that scales by s, then rotates by q, then translates by t.
     *
     * @param q quaternion x, y, z, w of any length; a zero quaternion does not rotate
     */
    static Affine of(double[] t, double[] q, double[] s) {
        double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        double f = square > 0 ? 2 / square : 0;
        double x = q[0];
        double y = q[1];
        double z = q[2];
        double w = q[3];
        return new Affine(new double[] {
            (1 - f * (y * y + z * z)) * s[0], f * (x * y - z * w) * s[1], f * (x * z + y * w) * s[2], t[0],
            f * (x * y + z * w) * s[0], (1 - f * (x * x + z * z)) * s[1], f * (y * z - x * w) * s[2], t[1],
            f * (x * z - y * w) * s[0], f * (y * z + x * w) * s[1], (1 - f * (x * x + y * y)) * s[2], t[2]});
    }

    /** Maps from instances' spaces to the node's (EXT_mesh_gpu_instancing); empty where the node has no instances. */
    static Optional<List<Affine>> instances(JsonCursor node, Accessors accessors, long most) throws IOException {
        Optional<JsonCursor> extension = node.extension("EXT_mesh_gpu_instancing");
        if (extension.isEmpty()) {
            return Optional.empty();
        }
        JsonCursor attributes = extension.get().at("attributes");
        List<String> names = List.of("TRANSLATION", "ROTATION", "SCALE");
        Map<String, float[]> values = new HashMap<>();
        int count = -1;
        for (String name : names) {
            Optional<JsonCursor> where = attributes.optional(name);
            if (where.isPresent()) {
                int own = accessors.count(where.get());
                if (own > most || count >= 0 && own != count) {
                    throw attributes.wrong("arrays of one length of at most " + most);
                }
                count = own;
                values.put(name, accessors.floats(where.get(), name.equals("ROTATION") ? "VEC4" : "VEC3"));
            }
        }
        if (count < 0) {
            return Optional.empty(); // attributes of an application only: all instances stand where the node is
        }
        List<Affine> instances = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            instances.add(of(values(values, "TRANSLATION", i, 0, 0, 0), values(values, "ROTATION", i, 0, 0, 0, 1),
                    values(values, "SCALE", i, 1, 1, 1)));
        }
        return Optional.of(instances);
    }

    private static double[] values(Map<String, float[]> of, String name, int i, double... otherwise) {
        float[] all = of.get(name);
        if (all != null) {
            for (int k = 0; k < otherwise.length; k++) {
                otherwise[k] = all[otherwise.length * i + k];
            }
        }
        return otherwise;
    }
}
