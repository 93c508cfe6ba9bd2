package radiosity.input.gltf;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import radiosity.gltf.GltfModel;
import radiosity.gltf.JsonCursor;
import radiosity.input.assembly.Placing;
import radiosity.input.assembly.SceneDraft;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.input.file.OpenedFile;
import radiosity.scene.Affine;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.scene.Units;
import radiosity.settings.ReadOptions;

/** Reads a glTF 2.0 file or binary: the default scene, at rest. */
public final class GltfReader {

    /** The extensions that a file may require. */
    private static final Set<String> READ = new TreeSet<>(Set.of("KHR_lights_punctual",
            "KHR_materials_emissive_strength", "KHR_materials_pbrSpecularGlossiness", "KHR_materials_unlit",
            "KHR_materials_ior", "KHR_materials_transmission", "KHR_materials_volume",
            "KHR_mesh_quantization", "KHR_texture_transform", "EXT_lights_ies", "EXT_mesh_gpu_instancing"));

    private final ReadOptions options;
    private final Diagnostics notes;
    private final JsonCursor root;
    private final SceneDraft draft;
    private final Accessors accessors;
    private final Materials materials;
    private final Meshes meshes;
    private final Nodes nodes;
    private final Views views;
    private final Map<String, Integer> geometries = new HashMap<>();
    private final Buffers buffers;
    private final List<Standing> standing = new ArrayList<>();
    /** See {@link Origins#nodes}. */
    private final List<Integer> numbers = new ArrayList<>();

    /**
     * A mesh placed in the scene.
     *
     * @param node     index of its node in the file
     * @param mesh     index of the mesh in the file
     * @param shape    morph weights and skin of the mesh at this node
     * @param world    map from the mesh's space to the scene's
     * @param instance map from the instance's space to the node's, if the node has instances
     */
    record Standing(int node, int mesh, Meshes.Shape shape, Affine world, Optional<Affine> instance) { }

    /**
     * Where a file describes what its scene has.
     *
     * @param json      the file's JSON, which the caller may modify
     * @param nodes     index in the file of each node of the scene's hierarchy; -1 for an instance of a node
     * @param materials index in the file of the material of each of the scene's surfaces; -1 for the default material
     */
    public record Origins(ObjectNode json, List<Integer> nodes, List<Integer> materials) { }

    private GltfReader(Container file, String name, FileSearch search, ReadOptions options, Diagnostics notes)
            throws IOException {
        this.options = options;
        this.notes = notes;
        root = file.root();
        checkExtensions();
        draft = new SceneDraft(name, true, options, notes);
        buffers = new Buffers(file, search, options);
        accessors = new Accessors(root, buffers);
        materials = new Materials(root, buffers, isPhotometric(), notes);
        meshes = new Meshes(root, accessors, materials, options, notes);
        nodes = new Nodes(root);
        views = new Views(root, buffers, notes, options.luminaires().keySet());
    }

    /**
     * Reads a file and the files that it names.
     *
     * @param options  how the file is read; its options of colour spaces have no effect, as glTF defines these
     * @param warnings receives one line, with file and place, for each kind of content that was left out or repaired
     * @return a scene of at least one triangle
     * @throws SceneFormatException if the content cannot be used, or under {@code strict} at the first warning
     * @throws IOException          if a file cannot be read
     */
    public static Scene read(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        OpenedFile opened = OpenedFile.of(file, options, warnings);
        return read(opened.bytes(), opened.name(), opened.search(), options, opened.notes());
    }

    /**
     * Makes a scene of the content of a file.
     *
     * @param bytes  the whole file
     * @param search finds the buffers and images that the file names
     */
    static Scene read(byte[] bytes, String name, FileSearch search, ReadOptions options, Diagnostics notes)
            throws IOException {
        return new GltfReader(Container.of(bytes, name, notes), name, search, options, notes).scene();
    }

    private void checkExtensions() throws SceneFormatException {
        for (JsonCursor extension : root.list("extensionsRequired")) {
            if (!READ.contains(extension.text())) {
                throw notes.error("JSON " + extension.path(), "extensions that are read (" + String.join(", ", READ)
                        + ")", extension.text());
            }
        }
    }

    private Scene scene() throws IOException {
        if (root.optional("animations").isPresent()) {
            notes.remark("animations are not evaluated: all stands at rest");
        }
        List<Integer> drafted = new ArrayList<>();
        for (Nodes.Placed at : nodes.all()) {
            int mesh = at.node().index("mesh");
            Optional<List<Affine>> instances = Nodes.instances(at.node(), accessors, SceneDraft.MOST_NODES);
            int node = draft.node(new SceneNode(at.node().text("name", ""),
                    at.parent() < 0 ? -1 : drafted.get(at.parent()), mesh < 0 || instances.isPresent() ? ""
                    : geometry(mesh), at.local()), at.node().path());
            drafted.add(node);
            numbers.add(at.number());
            views.add(at);
            if (mesh >= 0 && instances.isPresent()) {
                for (Affine instance : instances.get()) {
                    int own = draft.node(new SceneNode(at.node().text("name", ""), node, geometry(mesh), instance),
                            at.node().path());
                    numbers.add(-1);
                    add(at, new Standing(at.number(), mesh, new Meshes.Shape(weights(at.node()), null),
                            at.world().times(instance), Optional.of(instance)), own);
                }
            } else if (mesh >= 0) {
                Meshes.Shape shape = new Meshes.Shape(weights(at.node()), skin(at.node()));
                add(at, new Standing(at.number(), mesh, shape, shape.skin() == null ? at.world() : Affine.IDENTITY,
                        Optional.empty()), node);
            }
        }
        List<Light> lights = views.lights().stream().filter(light -> options.lights() != ReadOptions.Lights.IGNORE
                || options.luminaires().containsKey(light.name())).toList();
        return draft.scene(meshes.surfaces(), lights, views.camera()).with(new Units(1, isPhotometric()));
    }

    /**
     * Whether light is in photometric units: where the options say so, luminaires are added, or the file has lights
     * that may be used.
     */
    private boolean isPhotometric() throws SceneFormatException {
        if (options.units().isPhotometric() || !options.luminaires().isEmpty()) {
            return true;
        }
        boolean hasLights = false;
        for (JsonCursor node : root.list("nodes")) {
            hasLights |= node.extension("KHR_lights_punctual").isPresent()
                    || node.extension("EXT_lights_ies").isPresent();
        }
        return hasLights && options.lights() != ReadOptions.Lights.IGNORE;
    }

    private void add(Nodes.Placed at, Standing mesh, int node) throws IOException {
        standing.add(mesh);
        for (Meshes.Part part : meshes.parts(mesh.mesh, mesh.shape)) {
            draft.add(part.triangles(), Placing.of(mesh.world), new int[] {part.surface()}, node, at.node().path());
        }
    }

    private static GltfReader again(Path file, ReadOptions options) throws IOException {
        OpenedFile opened = OpenedFile.of(file, options.withStrict(false), warning -> { });
        GltfReader reader = new GltfReader(Container.of(opened.bytes(), opened.name(), opened.notes()), opened.name(),
                opened.search(), options, opened.notes());
        reader.scene();
        return reader;
    }

    /**
     * Finds where a file describes what its scene has.
     *
     * @param options the options with which the scene was read
     */
    public static Origins origins(Path file, ReadOptions options) throws IOException {
        GltfReader reader = again(file, options);
        return new Origins(reader.root.node().deepCopy(), reader.numbers, reader.materials.numbers());
    }

    /**
     * Reads a file again, completely, for a writer that adds to it.
     *
     * @param options the options with which the scene was read
     * @param scene   the scene that was read from the file
     */
    public static GltfModel original(Path file, ReadOptions options, Scene scene) throws IOException {
        GltfReader reader = again(file, options);
        return new OriginalModel(reader.root, reader.buffers, reader.meshes).of(reader.standing, scene);
    }

    /** The name of a mesh, followed by the mesh's number if an earlier mesh has the same name. */
    private String geometry(int mesh) throws SceneFormatException {
        String name = root.at("meshes").at(mesh).text("name", "mesh " + mesh);
        return geometries.computeIfAbsent(name, n -> mesh) == mesh ? name : name + "#" + mesh;
    }

    private static double[] weights(JsonCursor node) throws SceneFormatException {
        Optional<JsonCursor> weights = node.optional("weights");
        return weights.isEmpty() ? new double[0] : weights.get().numbers(weights.get().size());
    }

    /** The skin of a node's mesh with its joints at rest; null where the node has none. */
    private Skin skin(JsonCursor node) throws IOException {
        if (node.optional("skin").isEmpty()) {
            return null;
        }
        JsonCursor skin = root.at("skins").at(node.at("skin").integer());
        JsonCursor joints = skin.at("joints");
        Optional<JsonCursor> bound = skin.optional("inverseBindMatrices");
        float[] inverse = bound.isEmpty() ? new float[0] : accessors.floats(bound.get(), "MAT4");
        if (bound.isPresent() && inverse.length < 16L * joints.size()) {
            throw bound.get().wrong("a matrix for each joint");
        }
        List<Affine> worlds = new ArrayList<>();
        for (int j = 0; j < joints.size(); j++) {
            Affine world = nodes.world(joints.at(j).integer()).orElse(Affine.IDENTITY);
            double[] numbers = new double[16];
            for (int i = 0; i < 16 && bound.isPresent(); i++) {
                numbers[i] = inverse[16 * j + i];
            }
            worlds.add(bound.isEmpty() ? world : world.times(Nodes.columns(numbers)));
        }
        return new Skin(worlds);
    }
}
