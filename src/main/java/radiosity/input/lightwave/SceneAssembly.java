package radiosity.input.lightwave;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import radiosity.input.assembly.Placing;
import radiosity.input.assembly.SceneDraft;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.input.file.FileSniffer;
import radiosity.input.file.InputFile;
import radiosity.input.file.WorkBudget;
import radiosity.input.lightwave.lwo.ObjectFile;
import radiosity.input.lightwave.lwo.ObjectModel;
import radiosity.input.lightwave.lws.Motion;
import radiosity.input.lightwave.lws.Placement;
import radiosity.input.lightwave.lws.SceneCamera;
import radiosity.input.lightwave.lws.SceneDescription;
import radiosity.input.lightwave.lws.SceneItem;
import radiosity.input.lightwave.lws.SceneLights;
import radiosity.input.lightwave.lws.SceneParser;
import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;

/** Assembles a scene from placed objects, their surfaces, lights and the camera. */
public final class SceneAssembly {

    private final String name;
    private final ReadOptions options;
    private final Diagnostics notes;
    private final SurfaceTable surfaces;
    private final SceneDraft draft;
    private List<Light> lights = List.of();
    private Optional<Camera> camera = Optional.empty();
    private SceneDescription description;
    private Placement placement;
    /** The objects in the order of the hierarchy's nodes, 1 per node. */
    private final List<SceneItem> objects = new ArrayList<>();

    private SceneAssembly(String name, ReadOptions options, Diagnostics notes) {
        this.name = name;
        this.options = options;
        this.notes = notes;
        this.surfaces = new SurfaceTable(options, notes);
        this.draft = new SceneDraft(name, false, options, notes);
    }

    /** A scene and its sources; description and placement are null and the items empty for an object file. */
    record Reading(Scene scene, SceneDescription description, Placement placement, List<SceneItem> objects) { }

    static Reading read(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        String name = String.valueOf(file.getFileName());
        byte[] bytes = InputFile.read(file, name, options.maxBytes());
        Diagnostics notes = new Diagnostics(name, warnings, options.strict());
        return read(bytes, name, search(file, options, notes), options, notes);
    }

    /** A search for the objects and images that a scene names. */
    static FileSearch search(Path scene, ReadOptions options, Diagnostics notes) throws IOException {
        return new FileSearch(scene, options.content(), options.map(), ObjectFile::isObject, notes);
    }

    /**
     * Makes a scene of the content of a file.
     *
     * @param bytes  the whole file
     * @param name   name of the file as the user knows it
     * @param search finds the objects and images that the file names
     */
    static Reading read(byte[] bytes, String name, FileSearch search, ReadOptions options, Diagnostics notes)
            throws IOException {
        SceneAssembly assembly = new SceneAssembly(name, options, notes);
        if (SceneParser.isScene(bytes)) {
            assembly.addScene(SceneParser.parse(bytes, notes), new ObjectLibrary(search, options, notes));
        } else if (ObjectFile.isObject(bytes)) {
            ObjectModel object = ObjectFile.read(bytes, name, notes);
            SurfaceImages.find(object, search, notes);
            assembly.addObject(object);
        } else {
            throw notes.error("", "a LightWave scene or object", FileSniffer.describe(bytes));
        }
        return new Reading(assembly.toScene(), assembly.description, assembly.placement, assembly.objects);
    }

    private void addObject(ObjectModel object) throws SceneFormatException {
        int node = draft.node(new SceneNode(name.replaceFirst("(?i)\\.lwo$", ""), -1, name, Affine.IDENTITY), "");
        ObjectMesh mesh = ObjectMesh.of(object, object.layers, new WorkBudget(), notes);
        draft.add(mesh.triangles(), Placing.leftHanded(Affine.IDENTITY), surfaceNumbers(mesh, name), node, "");
    }

    private void addScene(SceneDescription scene, ObjectLibrary library) throws IOException {
        double frame = options.frame().orElse(scene.firstFrame());
        Motion.Instant instant = new Motion.Instant(frame, scene.framesPerSecond());
        description = scene;
        placement = new Placement(scene, instant, notes);
        List<SceneItem> objects = scene.items(SceneItem.Kind.OBJECT);
        List<Optional<ObjectLibrary.Part>> parts = new ArrayList<>();
        for (SceneItem object : objects) {
            Optional<ObjectLibrary.Part> part = object.isLoaded() ? library.part(object) : Optional.empty();
            part.ifPresent(p -> placement.layerPivot(object, p.mesh().pivot()));
            parts.add(part.filter(p -> isSeen(object, instant)));
        }
        library.flush();
        int[] nodes = addNodes(objects, parts);
        for (int i = 0; i < parts.size(); i++) {
            if (parts.get(i).isPresent()) {
                ObjectLibrary.Part part = parts.get(i).get();
                draft.add(part.mesh().triangles(), Placing.leftHanded(placement.world(objects.get(i))),
                        surfaceNumbers(part.mesh(), part.name()), nodes[i], objects.get(i).place());
            }
        }
        lights = new SceneLights(scene, placement, instant, notes, options.luminaires().keySet()).lights();
        camera = new SceneCamera(scene, placement, instant, notes).camera();
    }

    private static boolean isSeen(SceneItem object, Motion.Instant instant) {
        return object.number(object.either("ObjectDissolve", "ObjDissolve"), instant, 0) < 1;
    }

    /**
     * Adds a node for each object, null objects included, parents first; an object without parent object is a root.
     *
     * @return the node of each object; 1 entry per object
     */
    private int[] addNodes(List<SceneItem> objects, List<Optional<ObjectLibrary.Part>> parts)
            throws SceneFormatException {
        Map<SceneItem, Integer> numbers = new IdentityHashMap<>();
        for (int i = 0; i < objects.size(); i++) {
            numbers.put(objects.get(i), i);
        }
        int[] nodes = new int[objects.size()];
        Arrays.fill(nodes, -1);
        for (SceneItem object : objects) {
            Deque<SceneItem> chain = new ArrayDeque<>();
            Set<SceneItem> inChain = Collections.newSetFromMap(new IdentityHashMap<>());
            for (SceneItem link = object; numbers.containsKey(link) && nodes[numbers.get(link)] < 0
                    && inChain.add(link); link = placement.parent(link)) {
                chain.push(link);
            }
            for (SceneItem link : chain) {
                Integer parent = numbers.get(placement.parent(link));
                boolean stands = parent == null || nodes[parent] < 0;
                Affine local = stands ? placement.world(link) : placement.local(link);
                this.objects.add(link);
                String geometry = parts.get(numbers.get(link)).map(ObjectLibrary.Part::geometry).orElse("");
                nodes[numbers.get(link)] = draft.node(new SceneNode(link.name(), stands ? -1 : nodes[parent], geometry,
                        rightHanded(local)), link.place());
            }
        }
        return nodes;
    }

    /** The same map between right-handed spaces, whose z axes point the other way. */
    private static Affine rightHanded(Affine map) {
        double[] m = map.m().clone();
        for (int i : new int[] {2, 6, 8, 9, 11}) {
            m[i] = 0 - m[i];
        }
        return new Affine(m);
    }

    private Scene toScene() throws SceneFormatException {
        return draft.scene(surfaces.surfaces(), takenLights(), camera);
    }

    /** The lights that the options take (under AUTO only where no surface emits), and those replaced by luminaires. */
    private List<Light> takenLights() {
        boolean emits = surfaces.surfaces().stream().anyMatch(Surface::emits);
        boolean taken = options.lights() == ReadOptions.Lights.EMITTERS
                || options.lights() == ReadOptions.Lights.AUTO && !emits;
        if (taken && lights.isEmpty() && !emits && surfaces.isAnySpecular()) {
            notes.remark("no surface emits, but some are specular: with emission specular (appendix B.2) they would");
        }
        if (!taken && !lights.isEmpty() && options.luminaires().isEmpty()
                && options.lights() == ReadOptions.Lights.AUTO) {
            notes.remark("surfaces emit, so the scene's lights are not used: " + lights.size());
        }
        return lights.stream().filter(light -> taken || options.luminaires().containsKey(light.name())).toList();
    }

    private int[] surfaceNumbers(ObjectMesh mesh, String file) {
        return mesh.surfaces().stream().mapToInt(used -> surfaces.index(file, used)).toArray();
    }
}
