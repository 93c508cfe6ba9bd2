package radiosity.output.gltf;

import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import radiosity.gltf.JsonCursor;
import radiosity.output.file.AtomicFile;
import radiosity.output.image.ToneMapping;
import radiosity.output.lightmap.TextureBake;
import radiosity.output.mesh.MergedMeshes;
import radiosity.output.mesh.Mesh;
import radiosity.output.mesh.TJunctions;
import radiosity.scene.Camera;
import radiosity.scene.Lamp;
import radiosity.scene.SceneNode;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.util.Aabb;

/**
 * The scene file: a glTF 2.0 binary that any glTF viewer opens, with everything that was computed (docs/FORMATS.md).
 *
 * <p>Writing is a call; reading opens the file, checks it and its version, and fetches meshes and state when they are
 * asked for. An open file stays the one that was opened, also when a render replaces it.
 */
public final class SceneFile implements Closeable {

    /** Written into every file; one with a higher number is refused. */
    public static final int FORMAT_VERSION = 1;
    /** What a file can be long. */
    public static final long MOST_BYTES = GlbWriter.MOST;
    /** Three corners. */
    public static final int BYTES_PER_ELEMENT = 12;
    /** Position, normal, irradiance, radiosity and colour. */
    public static final int BYTES_PER_VERTEX = 56;
    /** Irradiance that is one lamp's, per vertex. */
    public static final int BYTES_PER_LAYER = 12;
    /** Positions count from the middle of the scene where it lies more than this times its size from the origin. */
    private static final double FAR = 4;
    /** Bytes of JSON that say where the state is, at most: a name of 255 bytes, and numbers. */
    private static final long STATE_IN_JSON = 1024;
    /** The camera's near plane, of the scene's size. */
    private static final double NEAR = 1e-3;

    private final GlbReader glb;
    private final JsonCursor radiosity;
    private final SceneMeshes meshes;

    private SceneFile(GlbReader glb) throws IOException {
        this.glb = glb;
        JsonCursor root = new JsonCursor(glb.name, glb.json);
        radiosity = root.optional("asset").flatMap(asset -> asset.optional("extras"))
                .flatMap(extras -> extras.optional("radiosity"))
                .orElseThrow(() -> glb.wrong("", "a scene file of this program", "another glTF file"));
        int version = radiosity.at("formatVersion").integer();
        if (version > FORMAT_VERSION) {
            throw glb.wrong("", "scene file format " + FORMAT_VERSION + " or older", "format " + version
                    + ", of a newer program");
        }
        meshes = new SceneMeshes(glb, lamps());
    }

    /**
     * Writes a solution, T-junctions closed, in place of what the file was before.
     *
     * @param extras of JSON's types, for the asset's extras.radiosity: "commandLine", "errorBound" and so on
     * @param camera from where to look at it
     */
    public static void write(Path file, Solution solution, Map<String, ?> extras, Optional<Camera> camera,
                             ToneMapping toneMapping) throws IOException {
        write(file, solution, extras, camera, toneMapping, OptionalDouble.empty());
    }

    /** @param samples of textures besides, per scene unit; empty for none */
    public static void write(Path file, Solution solution, Map<String, ?> extras, Optional<Camera> camera,
                             ToneMapping toneMapping, OptionalDouble samples) throws IOException {
        write(file, solution, extras, camera, toneMapping, samples, GlbWriter.MOST);
    }

    /** @param most bytes of a scene file: a state that does not fit stands in a file beside it */
    static void write(Path file, Solution solution, Map<String, ?> extras, Optional<Camera> camera,
                      ToneMapping toneMapping, OptionalDouble samples, long most) throws IOException {
        Solution closed = TJunctions.close(solution);
        Aabb box = Aabb.of(closed.positions());
        Vec3 origin = origin(box);
        SceneDocument document = new SceneDocument(closed.scene().name(), program(), origin,
                closed.scene().hierarchy().written());
        for (Mesh mesh : Mesh.of(closed, origin)) {
            document.mesh(mesh, toneMapping);
        }
        document.placeMeshes();
        double near = box.diagonal() > 0 ? NEAR * box.diagonal() : NEAR;
        camera.ifPresent(c -> document.camera(c, near, origin));
        Map<String, Object> content = content(closed, extras);
        if (samples.isPresent()) {
            document.beginTextures(origin);
            new TextureBake(closed, origin, samples.getAsDouble()).bake(side -> document.texture(side, toneMapping));
            content.put("textures", Map.of("samples", samples.getAsDouble(), "curve", toneMapping.operator().name(),
                    "exposure", toneMapping.exposure()));
        }
        document.extras("radiosity", content);
        String beside = state(file, closed.state(), content, document, most);
        document.extras("radiosity", content);
        byte[] json = document.json();
        AtomicFile.write(file, channel -> GlbWriter.write(channel, json, document.arrays));
        StateFile.deleteOthers(file, beside);
    }

    /**
     * Puts the state into the document, or into a file beside it, and where it is into the content.
     *
     * @return name of the file beside it, or an empty text
     */
    private static String state(Path file, SavedState state, Map<String, Object> content, SceneDocument document,
                                long most) throws IOException {
        long json = document.json().length + STATE_IN_JSON;
        GlbWriter.check(GlbWriter.size(json, document.binLength()), most);
        if (state.isEmpty()) {
            return "";
        }
        if (GlbWriter.size(json, document.binLength() + GlbWriter.padded(state.length())) <= most) {
            content.put("state", Map.of("bufferView", document.view(state), "sha256", state.sha256()));
            return "";
        }
        String name = StateFile.write(file, state);
        content.put("state", Map.of("file", name, "bytes", state.length(), "sha256", state.sha256()));
        return name;
    }

    /** Zero, or a point near the middle whose coordinates are floats, so that viewers add them exactly. */
    private static Vec3 origin(Aabb box) {
        Vec3 c = box.centre();
        boolean far = Math.max(Math.abs(c.x()), Math.max(Math.abs(c.y()), Math.abs(c.z()))) > FAR * box.diagonal();
        return far ? new Vec3((float) c.x(), (float) c.y(), (float) c.z()) : Vec3.ZERO;
    }

    private static Map<String, Object> content(Solution solution, Map<String, ?> extras) {
        Map<String, Object> content = new TreeMap<>(extras);
        content.put("formatVersion", FORMAT_VERSION);
        content.put("program", program());
        content.put("channels", solution.channels());
        content.put("shots", solution.shots());
        content.put("rounds", solution.rounds());
        content.put("unshotFlux", solution.unshotFlux());
        content.put("ledger", solution.ledger());
        if (!solution.lamps().isEmpty()) {
            content.put("lamps", solution.lamps());
        }
        return content;
    }

    /** Name and version of this program. */
    private static String program() {
        String version = SceneFile.class.getPackage().getImplementationVersion();
        return "radiosity " + (version == null ? "(not packaged)" : version);
    }

    /**
     * Opens a scene file and reads what stands in its JSON.
     *
     * @throws radiosity.scene.SceneFormatException if it is not one, is cut off, or is of a newer program
     */
    public static SceneFile open(Path file) throws IOException {
        GlbReader glb = new GlbReader(file);
        try {
            return new SceneFile(glb);
        } catch (IOException | RuntimeException e) {
            glb.close();
            throw e;
        }
    }

    /** One mesh per object and side of a surface, in the order of the file. */
    public List<Mesh> meshes() throws IOException {
        return meshes.read();
    }

    /** The objects of the input, each after its parent; empty where it named none. */
    public List<SceneNode> objects() throws IOException {
        return meshes.objects();
    }

    /** Whose light is kept apart in layers; empty where it is not. */
    public List<Lamp> lamps() throws IOException {
        List<Lamp> lamps = new ArrayList<>();
        for (JsonCursor lamp : radiosity.list("lamps")) {
            lamps.add(new Lamp(lamp.at("name").text(), lamp.at("surface").node().booleanValue(),
                    lamp.at("index").integer()));
        }
        return lamps;
    }

    /** The sides of surfaces with their light in textures; empty where it was written without. */
    public List<TexturedMesh> textures() throws IOException {
        return meshes.readTextured();
    }

    /** How radiosity became the colours of the textures; empty where there are none. */
    public Optional<ToneMapping> textureToneMapping() throws IOException {
        Optional<JsonCursor> textures = radiosity.optional("textures");
        if (textures.isEmpty()) {
            return Optional.empty();
        }
        try {
            return Optional.of(new ToneMapping(ToneMapping.Operator.valueOf(textures.get().at("curve").text()),
                    textures.get().at("exposure").number()));
        } catch (IllegalArgumentException e) {
            throw textures.get().wrong("a tone mapping");
        }
    }

    /** What to add to the meshes' positions, scene units. */
    public Vec3 origin() throws IOException {
        return meshes.origin();
    }

    public Optional<Camera> camera() throws IOException {
        return meshes.camera();
    }

    /** The asset's extras.radiosity in Java's types: String, Boolean, Integer, Long, Double, List, Map. */
    public Map<String, Object> extras() {
        return new ObjectMapper().convertValue(radiosity.node(), new TypeReference<>() { });
    }

    /** Where the light went. */
    public EnergyLedger ledger() throws IOException {
        JsonCursor ledger = radiosity.at("ledger");
        int channels = ledger.at("emitted").size();
        return new EnergyLedger(ledger.at("emitted").numbers(channels), ledger.at("shot").numbers(channels),
                ledger.at("received").numbers(channels), ledger.at("absorbed").numbers(channels),
                ledger.at("unshot").numbers(channels));
    }

    /** Whether the file has what resuming needs. */
    public boolean hasState() {
        return radiosity.optional("state").isPresent();
    }

    /** Reads what resuming needs; empty where the file has none. For one thread at a time. */
    public SavedState state() throws IOException {
        Optional<JsonCursor> place = radiosity.optional("state");
        if (place.isEmpty()) {
            return SavedState.NONE;
        }
        SavedState state = place.get().optional("file").isEmpty()
                ? glb.state(place.get().at("bufferView").integer())
                : StateFile.read(Path.of(glb.name), place.get().at("file").text(), place.get().at("bytes").unchecked());
        String expected = place.get().at("sha256").text();
        if (!state.sha256().equals(expected)) {
            throw glb.wrong("state", "SHA-256 " + expected, state.sha256());
        }
        return state;
    }

    /**
     * The file as a solution whose original triangles are its elements: for pictures and values at points, not for
     * resuming.
     */
    public Solution solution() throws IOException {
        int shots = radiosity.at("shots").integer();
        int rounds = radiosity.at("rounds").integer();
        return new MergedMeshes(meshes.read(), meshes.origin()).solution(glb.name, shots, rounds,
                radiosity.at("unshotFlux").number(), ledger(), meshes.camera());
    }

    JsonCursor root() {
        return new JsonCursor(glb.name, glb.json);
    }

    @Override
    public void close() throws IOException {
        glb.close();
    }
}
