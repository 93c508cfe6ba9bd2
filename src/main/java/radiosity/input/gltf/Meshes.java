package radiosity.input.gltf;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.gltf.JsonCursor;
import radiosity.input.assembly.SmoothEdges;
import radiosity.input.assembly.TriangleMesh;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FloatList;
import radiosity.input.file.IntList;
import radiosity.input.file.MemoryAdvice;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** The meshes of a glTF file as triangles; a mesh without skin and node weights is read once for all its nodes. */
final class Meshes {

    private static final int TRIANGLES = 4;
    private static final int STRIP = 5;
    private static final int FAN = 6;
    /** Heap bytes that one triangle takes while it is read. */
    private static final int TRIANGLE_BYTES = 140;

    private final JsonCursor root;
    private final Accessors accessors;
    private final Materials materials;
    private final ReadOptions options;
    private final Diagnostics notes;
    private final SmoothEdges edges = new SmoothEdges();
    private long total;
    private final Map<Integer, List<Part>> known = new HashMap<>();

    /**
     * The triangles of one primitive, and so of one material.
     *
     * @param surface   index of the triangles' surface
     * @param primitive index of the primitive in its mesh
     * @param vertices  indices of the primitive's vertices, 3 per triangle; not to be modified
     */
    record Part(TriangleMesh triangles, int surface, int primitive, int[] vertices) { }

    /**
     * How a node deforms the vertices of its mesh, at rest.
     *
     * @param weights weights of the morph targets; may be empty
     * @param skin    moves the vertices directly to the scene's space; null for none
     */
    record Shape(double[] weights, Skin skin) { }

    Meshes(JsonCursor root, Accessors accessors, Materials materials, ReadOptions options,
           Diagnostics notes) {
        this.root = root;
        this.accessors = accessors;
        this.materials = materials;
        this.options = options;
        this.notes = notes;
    }

    /** The parts of a mesh, with the morph weights and the skin of a node. */
    List<Part> parts(int number, Shape shape) throws IOException {
        boolean changed = shape.skin() != null || shape.weights().length > 0;
        List<Part> parts = changed ? null : known.get(number);
        if (parts == null) {
            parts = new ArrayList<>();
            JsonCursor mesh = root.at("meshes").at(number);
            Optional<JsonCursor> defaults = mesh.optional("weights");
            double[] weights = shape.weights().length > 0 || defaults.isEmpty() ? shape.weights()
                    : defaults.get().numbers(defaults.get().size());
            JsonCursor primitives = mesh.at("primitives");
            for (int i = 0; i < primitives.size(); i++) {
                add(primitives.at(i), i, new Shape(weights, shape.skin()), parts);
            }
            if (!changed) {
                known.put(number, parts);
            }
        }
        return parts;
    }

    private void add(JsonCursor primitive, int number, Shape shape, List<Part> parts) throws IOException {
        int mode = primitive.optional("mode").isPresent() ? primitive.index("mode") : TRIANGLES;
        JsonCursor attributes = primitive.at("attributes");
        if (mode < TRIANGLES || attributes.optional("POSITION").isEmpty()) {
            return;
        }
        if (mode > FAN) {
            throw primitive.at("mode").wrong("a mode from 0 to 6");
        }
        if (!accessors.hasData(attributes.at("POSITION"))) {
            Buffers.refuseCompressed(primitive, "KHR_draco_mesh_compression");
        }
        float[] points = points(primitive, attributes, shape);
        int[] corners = triangles(primitive, mode, points);
        if (corners.length > 0) {
            parts.add(part(attributes, points, corners, materials.surface(primitive.index("material")), number));
        }
    }

    /** Counts further triangles and moved vertices, and fails where they exceed the limits. */
    private void reserve(JsonCursor where, long more) throws SceneFormatException {
        total += more;
        if (total > options.maxTriangles()) {
            throw where.wrong("meshes of at most " + options.maxTriangles() + " triangles");
        }
        long most = Runtime.getRuntime().maxMemory() / 2 / TRIANGLE_BYTES;
        if (total > most) {
            throw where.wrong("meshes of at most " + most + " triangles (half of the memory; "
                    + MemoryAdvice.forBytes(2 * TRIANGLE_BYTES * total) + ")");
        }
    }

    /** x, y, z of each vertex, moved by morph targets and joints; not to be modified. */
    private float[] points(JsonCursor primitive, JsonCursor attributes, Shape shape) throws IOException {
        float[] points = accessors.floats(attributes.at("POSITION"), "VEC3");
        Optional<JsonCursor> targets = primitive.optional("targets");
        if (targets.isPresent() && Arrays.stream(shape.weights()).anyMatch(w -> w != 0)) {
            reserve(primitive, points.length / 3);
            points = points.clone();
            for (int t = 0; t < Math.min(targets.get().size(), shape.weights().length); t++) {
                Optional<JsonCursor> moved = targets.get().at(t).optional("POSITION");
                if (moved.isPresent() && shape.weights()[t] != 0) {
                    float[] by = sameLength(moved.get(), accessors.floats(moved.get(), "VEC3"), points.length);
                    for (int i = 0; i < points.length; i++) {
                        points[i] += (float) (shape.weights()[t] * by[i]);
                    }
                }
            }
        }
        if (shape.skin() != null && attributes.optional("JOINTS_0").isPresent()) {
            reserve(primitive, points.length / 3);
            points = points.clone();
            List<float[]> joints = new ArrayList<>();
            List<float[]> weights = new ArrayList<>();
            for (int i = 0; attributes.optional("JOINTS_" + i).isPresent(); i++) {
                JsonCursor joint = attributes.at("JOINTS_" + i);
                JsonCursor weight = attributes.at("WEIGHTS_" + i);
                joints.add(sameLength(joint, accessors.floats(joint, "VEC4"), points.length / 3 * 4));
                weights.add(sameLength(weight, accessors.floats(weight, "VEC4"), points.length / 3 * 4));
            }
            shape.skin().move(points, joints, weights);
        }
        return points;
    }

    private static float[] sameLength(JsonCursor where, float[] values, int length) throws SceneFormatException {
        if (values.length != length) {
            throw where.wrong("an array as long as POSITION");
        }
        return values;
    }

    /** 3 vertex indices per triangle; triangles with missing or non-finite vertices are dropped with a note. */
    private int[] triangles(JsonCursor primitive, int mode, float[] points) throws IOException {
        int vertices = points.length / 3;
        Optional<JsonCursor> where = primitive.optional("indices");
        int[] indices = where.isPresent() ? accessors.indices(where.get()) : null;
        int count = indices == null ? vertices : indices.length;
        int triangles = mode == TRIANGLES ? count / 3 : Math.max(0, count - 2);
        reserve(primitive, triangles);
        IntList corners = new IntList();
        for (int t = 0; t < triangles; t++) {
            int[] three = switch (mode) {
                case STRIP -> t % 2 == 0 ? new int[] {t, t + 1, t + 2} : new int[] {t + 1, t, t + 2};
                case FAN -> new int[] {t + 1, t + 2, 0};
                default -> new int[] {3 * t, 3 * t + 1, 3 * t + 2};
            };
            boolean sound = true;
            for (int k = 0; k < 3; k++) {
                three[k] = indices == null ? three[k] : indices[three[k]];
                sound &= three[k] >= 0 && three[k] < vertices;
            }
            if (!sound) {
                notes.note(primitive.path(), "triangles with vertices that do not exist are dropped");
            } else if (!isFinite(points, three)) {
                notes.note(primitive.path(), "triangles with coordinates that are no finite numbers are dropped");
            } else {
                corners.add(three[0]);
                corners.add(three[1]);
                corners.add(three[2]);
            }
        }
        return corners.toArray();
    }

    private static boolean isFinite(float[] points, int[] three) {
        for (int vertex : three) {
            for (int k = 0; k < 3; k++) {
                if (!Float.isFinite(points[3 * vertex + k])) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Triangles with the points that they use, and the texture coordinates and colours of their corners. */
    private Part part(JsonCursor attributes, float[] given, int[] corners, int surface, int primitive)
            throws IOException {
        Map<Integer, Integer> numbers = new HashMap<>();
        FloatList points = new FloatList();
        int[] local = new int[corners.length];
        for (int i = 0; i < corners.length; i++) {
            Integer number = numbers.get(corners[i]);
            if (number == null) {
                number = points.size() / 3;
                numbers.put(corners[i], number);
                for (int k = 0; k < 3; k++) {
                    points.add(given[3 * corners[i] + k]);
                }
            }
            local[i] = number;
        }
        Optional<JsonCursor> normals = attributes.optional("NORMAL");
        float[] n = normals.isEmpty() ? new float[0]
                : sameLength(normals.get(), accessors.floats(normals.get(), "VEC3"), given.length);
        int[] surfaces = new int[corners.length / 3];
        Arrays.fill(surfaces, surface);
        edges.add(given, corners, surfaces, (i, j) -> n.length > 0 && areEqual(n, corners[i], corners[j]));
        float[] where = coordinates(attributes, surface, corners, given.length / 3);
        return new Part(new TriangleMesh(points.toArray(), local, new int[corners.length / 3], where,
                colours(attributes, surface, where.length > 0 && materials.hasImage(surface), corners,
                        given.length / 3)), surface, primitive, corners);
    }

    private static boolean areEqual(float[] normals, int v, int w) {
        return SmoothEdges.areEqual(new Vec3(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]),
                new Vec3(normals[3 * w], normals[3 * w + 1], normals[3 * w + 2]));
    }

    /** The surfaces of the materials used so far, with smoothing angles by the normals of the meshes read so far. */
    List<Surface> surfaces() {
        return edges.apply(materials.surfaces());
    }

    private float[] coordinates(JsonCursor attributes, int surface, int[] corners, int vertices) throws IOException {
        Optional<TextureLie> lie = materials.lie(surface);
        Optional<JsonCursor> where = lie.flatMap(l -> attributes.optional("TEXCOORD_" + l.set()));
        if (where.isEmpty()) {
            return new float[0];
        }
        float[] given = sameLength(where.get(), accessors.floats(where.get(), "VEC2"), 2 * vertices);
        float[] uv = new float[2 * corners.length];
        for (int i = 0; i < corners.length; i++) {
            uv[2 * i] = lie.get().u(given[2 * corners[i]], given[2 * corners[i] + 1]);
            uv[2 * i + 1] = lie.get().v(given[2 * corners[i]], given[2 * corners[i] + 1]);
        }
        return uv;
    }

    /**
     * Factors of the reflectance, 9 per triangle, in [0, 1]; empty where all are 1.
     *
     * @param hasImage whether an image gives the reflectance, so that the surface's own excess does not count
     */
    private float[] colours(JsonCursor attributes, int surface, boolean hasImage, int[] corners, int vertices)
            throws IOException {
        Rgb excess = hasImage ? Rgb.grey(1) : materials.excess(surface);
        Optional<JsonCursor> where = attributes.optional("COLOR_0");
        if (where.isEmpty()) {
            if (excess.max() > 1) {
                materials.tellClipped(surface);
            }
            return new float[0];
        }
        int width = accessors.type(where.get()).equals("VEC4") ? 4 : 3;
        float[] given = sameLength(where.get(), accessors.floats(where.get(), "VEC3", "VEC4"), width * vertices);
        float[] colours = new float[3 * corners.length];
        boolean white = true;
        for (int i = 0; i < colours.length; i++) {
            double colour = given[width * corners[i / 3] + i % 3] * excess.channel(i % 3);
            if (colour > 1 && excess.max() > 1) {
                materials.tellClipped(surface);
            }
            colours[i] = colour >= 0 ? (float) Math.min(1, colour) : 0;
            white &= colours[i] == 1;
        }
        return white ? new float[0] : colours;
    }
}
