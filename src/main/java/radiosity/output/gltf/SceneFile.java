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
import radiosity.gltf.Glb;
import radiosity.gltf.JsonCursor;
import radiosity.output.file.AtomicFile;
import radiosity.output.image.ToneMapping;
import radiosity.output.lightmap.TextureBake;
import radiosity.output.mesh.MergedMeshes;
import radiosity.output.mesh.Mesh;
import radiosity.output.mesh.SmoothShading;
import radiosity.output.mesh.TJunctions;
import radiosity.scene.Camera;
import radiosity.scene.Lamp;
import radiosity.scene.SceneNode;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.util.Aabb;

/**
 * The scene file: a glTF 2.0 binary that any glTF viewer opens, with all results of a calculation (docs/FORMATS.md).
 *
 * <p>A static method writes a file. To read, {@link #open} checks a file and its version; meshes and state are read
 * when the caller asks for them. An open file stays the same, even if a render replaces it meanwhile.
 */
public final class SceneFile implements Closeable {

    /** Version of the format, which stands in every file; files of a higher version are refused. */
    public static final int FORMAT_VERSION = 1;
    /** Largest length of a file, bytes. */
    public static final long MOST_BYTES = GlbWriter.MOST;
    /** Bytes for the three corners of an element. */
    public static final int BYTES_PER_ELEMENT = 12;
    /** Bytes for position, normal, irradiance, radiosity and colour of a vertex. */
    public static final int BYTES_PER_VERTEX = 56;
    /** Bytes for the irradiance from one lamp, per vertex. */
    public static final int BYTES_PER_LAYER = 12;
    /** Positions count from the scene's middle if one of its coordinates exceeds this many diagonals of the scene. */
    private static final double FAR = 4;
    /** Largest number of bytes of JSON that say where the state is: a name of 255 bytes, and numbers. */
    private static final long STATE_IN_JSON = 1024;
    /** Distance of the camera's near plane, of the scene's diagonal. */
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
     * Writes a solution with T-junctions closed; the file replaces an older one.
     *
     * @param extras      values of JSON's types for the asset's extras.radiosity: "commandLine", "errorBound" and so on
     * @param camera      from which viewers begin
     * @param toneMapping from radiosity to the vertex colours
     */
    public static void write(Path file, Solution solution, Map<String, ?> extras, Optional<Camera> camera,
                             ToneMapping toneMapping) throws IOException {
        write(file, solution, extras, camera, toneMapping, OptionalDouble.empty());
    }

    /** @param samples texels of additional textures per scene unit; empty for no textures */
    public static void write(Path file, Solution solution, Map<String, ?> extras, Optional<Camera> camera,
                             ToneMapping toneMapping, OptionalDouble samples) throws IOException {
        write(file, solution, extras, camera, toneMapping, samples, GlbWriter.MOST);
    }

    /** @param most largest length of a scene file, bytes: a state that does not fit is written to a file beside it */
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
            new TextureBake(SmoothShading.shown(closed), origin, samples.getAsDouble())
                    .bake(side -> document.texture(side, toneMapping));
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
     * Puts the state into the document or, if it does not fit, into a file beside the scene file, and its place into
     * the content.
     *
     * @return name of the file beside the scene file, or an empty text
     */
    private static String state(Path file, SavedState state, Map<String, Object> content, SceneDocument document,
                                long most) throws IOException {
        long json = document.json().length + STATE_IN_JSON;
        GlbWriter.check(GlbWriter.size(json, document.binLength()), most);
        if (state.isEmpty()) {
            return "";
        }
        if (GlbWriter.size(json, document.binLength() + Glb.padded(state.length())) <= most) {
            content.put("state", Map.of("bufferView", document.view(state), "sha256", state.sha256()));
            return "";
        }
        String name = StateFile.write(file, state);
        content.put("state", Map.of("file", name, "bytes", state.length(), "sha256", state.sha256()));
        return name;
    }

    /**
     * Zero or, far from zero, a point near the middle whose coordinates are floats, so that viewers add them exactly.
     */
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
        content.put("units", units(solution.scene().units()));
        if (!solution.lamps().isEmpty()) {
            content.put("lamps", solution.lamps());
        }
        return content;
    }

    /** The units as the file says them: without a length where it is not known. */
    private static Map<String, Object> units(Units units) {
        Map<String, Object> said = new TreeMap<>();
        said.put("photometric", units.isPhotometric());
        if (units.isLengthKnown()) {
            said.put("metres", units.metres());
        }
        return said;
    }

    /** Name and version of this program. */
    private static String program() {
        String version = SceneFile.class.getPackage().getImplementationVersion();
        return "radiosity " + (version == null ? "(not packaged)" : version);
    }

    /**
     * Opens a scene file and reads its JSON.
     *
     * @throws radiosity.scene.SceneFormatException if the file is no scene file, is cut off, or is of a newer program
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

    /** Reads the meshes, one per object and side of a surface, in the order of the file. */
    public List<Mesh> meshes() throws IOException {
        return meshes.read();
    }

    /** The objects of the input, each after its parent; empty if the input named none. */
    public List<SceneNode> objects() throws IOException {
        return meshes.objects();
    }

    /** The lamps whose light is kept apart, in the order of the layers; empty if no light is kept apart. */
    public List<Lamp> lamps() throws IOException {
        List<Lamp> lamps = new ArrayList<>();
        for (JsonCursor lamp : radiosity.list("lamps")) {
            lamps.add(new Lamp(lamp.at("name").text(), lamp.at("surface").node().booleanValue(),
                    lamp.at("index").integer()));
        }
        return lamps;
    }

    /** Reads the sides of surfaces with their light in textures; empty if the file has no textures. */
    public List<TexturedMesh> textures() throws IOException {
        return meshes.readTextured();
    }

    /** The tone mapping from radiosity to the colours of the textures; empty if the file has no textures. */
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

    /** The vector to be added to the positions of all meshes, scene units. */
    public Vec3 origin() throws IOException {
        return meshes.origin();
    }

    /**
     * The units of the file's numbers; radiometric and of unknown length where an earlier program wrote the file, which
     * did not say them.
     *
     * @throws radiosity.scene.SceneFormatException where the length is not a finite number above 0
     */
    public Units units() throws IOException {
        Optional<JsonCursor> units = radiosity.optional("units");
        if (units.isEmpty()) {
            return Units.UNKNOWN;
        }
        Optional<JsonCursor> metres = units.get().optional("metres");
        try {
            return new Units(metres.isEmpty() ? Double.NaN : metres.get().number(),
                    units.get().at("photometric").node().booleanValue());
        } catch (IllegalArgumentException e) {
            throw units.get().at("metres").wrong("a length above 0");
        }
    }

    public Optional<Camera> camera() throws IOException {
        return meshes.camera();
    }

    /** The asset's extras.radiosity in Java's types: String, Boolean, Integer, Long, Double, List, Map. */
    public Map<String, Object> extras() {
        return new ObjectMapper().convertValue(radiosity.node(), new TypeReference<>() { });
    }

    public EnergyLedger ledger() throws IOException {
        JsonCursor ledger = radiosity.at("ledger");
        int channels = ledger.at("emitted").size();
        return new EnergyLedger(ledger.at("emitted").numbers(channels), ledger.at("shot").numbers(channels),
                ledger.at("received").numbers(channels), ledger.at("absorbed").numbers(channels),
                ledger.at("unshot").numbers(channels),
                ledger.optional("escaped").isEmpty() || ledger.at("escaped").size() == 0 ? new double[0]
                        : ledger.at("escaped").numbers(channels));
    }

    /** Sum of |U| A over elements and channels, exitance times square scene units. */
    double unshotFlux() throws IOException {
        return radiosity.at("unshotFlux").number();
    }

    /** Whether the file has a state, from which a calculation can go on. */
    public boolean hasState() {
        return radiosity.optional("state").isPresent();
    }

    /**
     * Reads the state, from which a calculation can go on; empty if the file has none. For one thread at a time.
     *
     * @throws radiosity.scene.SceneFormatException if the state's SHA-256 is not that of the JSON, or its file is
     *         missing
     */
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

    /** The file as a solution without state whose triangles are its elements: for pictures and light at points. */
    public Solution solution() throws IOException {
        int shots = radiosity.at("shots").integer();
        int rounds = radiosity.at("rounds").integer();
        return MergedMeshes.solution(meshes.read(), meshes.origin(), glb.name, shots, rounds,
                unshotFlux(), ledger(), meshes.camera(), units());
    }

    JsonCursor root() {
        return new JsonCursor(glb.name, glb.json);
    }

    @Override
    public void close() throws IOException {
        glb.close();
    }
}
