package radiosity.input.lightwave;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.input.file.FileSniffer;
import radiosity.input.file.InputFile;
import radiosity.input.file.ReadOptions;
import radiosity.input.file.WorkBudget;
import radiosity.input.lightwave.lwo.ObjectFile;
import radiosity.input.lightwave.lwo.ObjectModel;
import radiosity.input.lightwave.lwo.SurfaceValues;
import radiosity.input.lightwave.lws.Matrix;
import radiosity.input.lightwave.lws.Motion;
import radiosity.input.lightwave.lws.Placement;
import radiosity.input.lightwave.lws.SceneCamera;
import radiosity.input.lightwave.lws.SceneDescription;
import radiosity.input.lightwave.lws.SceneItem;
import radiosity.input.lightwave.lws.SceneLights;
import radiosity.input.lightwave.lws.SceneParser;
import radiosity.scene.Camera;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Surface;

/** Brings together what a scene is made of: placed objects, their surfaces, lights and the camera. */
public final class SceneAssembly {

    /** Memory that one triangle and one point take in a scene, bytes. */
    private static final int TRIANGLE_BYTES = 16 + 24;
    private static final int POINT_BYTES = 24;
    /** Coordinates beyond this lose their squares. */
    private static final double FARTHEST = 1e70;

    private final String name;
    private final ReadOptions options;
    private final Diagnostics notes;
    private final SurfaceTable surfaces;
    private final List<Instance> instances = new ArrayList<>();
    private List<Light> lights = List.of();
    private Optional<Camera> camera = Optional.empty();
    private SceneDescription description;
    private Placement placement;

    /** A mesh, where it stands, and the file it is from. */
    private record Instance(ObjectMesh mesh, Matrix world, String file) { }

    private SceneAssembly(String name, ReadOptions options, Diagnostics notes) {
        this.name = name;
        this.options = options;
        this.notes = notes;
        this.surfaces = new SurfaceTable(options, notes);
    }

    /** A scene with what it was made from; an object alone has no description and no placement. */
    record Reading(Scene scene, SceneDescription description, Placement placement) { }

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
     * Reads what has been read from a file.
     *
     * @param bytes  the whole file
     * @param name   as the user knows it
     * @param search for the objects and images it names
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
        return new Reading(assembly.toScene(), assembly.description, assembly.placement);
    }

    private void addObject(ObjectModel object) {
        instances.add(new Instance(ObjectMesh.of(object, object.layers, new WorkBudget(), notes), Matrix.IDENTITY,
                name));
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
        for (int i = 0; i < parts.size(); i++) {
            if (parts.get(i).isPresent()) {
                addInstance(parts.get(i).get(), placement.world(objects.get(i)), objects.get(i));
            }
        }
        lights = new SceneLights(scene, placement, instant, notes).lights();
        camera = new SceneCamera(scene, placement, instant, notes).camera();
    }

    private static boolean isSeen(SceneItem object, Motion.Instant instant) {
        String keyword = object.has("ObjectDissolve") ? "ObjectDissolve" : "ObjDissolve";
        return object.number(keyword, instant, 0) < 1;
    }

    private void addInstance(ObjectLibrary.Part part, Matrix world, SceneItem object) {
        double reach = 0;
        for (float x : part.mesh().points()) {
            reach = Math.max(reach, Math.abs(x));
        }
        double factor = 0;
        for (double m : world.m()) {
            factor += Math.abs(m);
        }
        if (factor * Math.max(1, reach) < FARTHEST) {
            instances.add(new Instance(part.mesh(), world, part.name()));
        } else {
            notes.note(object.place(), "objects too large or too far away for their numbers are left out", part.name());
        }
    }

    /** Places all instances; a scene without a triangle is an error. */
    private Scene toScene() throws SceneFormatException {
        Triangles triangles = place();
        if (triangles.flat() > 0) {
            notes.note("", "triangles without area where they are placed are left out",
                    triangles.flat() + " triangles");
        }
        if (triangles.surfaceOf().length == 0) {
            notes.flush();
            throw notes.error("", "at least one polygon with an area", "none");
        }
        List<Light> taken = takenLights();
        notes.flush();
        return new Scene(name, triangles.points(), triangles.corners(), triangles.surfaceOf(), surfaces.surfaces(),
                taken, camera, triangles.textureCoordinates());
    }

    /** The lights that the options take: with "auto" none where a surface emits. */
    private List<Light> takenLights() {
        boolean emits = surfaces.surfaces().stream().anyMatch(Surface::emits);
        boolean taken = options.lights() == ReadOptions.Lights.EMITTERS
                || options.lights() == ReadOptions.Lights.AUTO && !emits;
        if (taken && lights.isEmpty() && !emits && surfaces.described().stream().anyMatch(s -> s.specular > 0)) {
            notes.tell("no surface emits, but some are specular: with emission specular (appendix B.2) they would");
        }
        if (!taken && !lights.isEmpty() && options.lights() == ReadOptions.Lights.AUTO) {
            notes.tell("surfaces emit, so the scene's lights are not used: " + lights.size());
        }
        return taken ? lights : List.of();
    }

    private Triangles place() throws SceneFormatException {
        long count = 0;
        long points = 0;
        boolean textured = false;
        for (Instance instance : instances) {
            count += instance.mesh.triangles();
            points += instance.mesh.pointCount();
            textured |= instance.mesh.textureCoordinates().length > 0;
        }
        checkBudget(count, points);
        Triangles triangles = new Triangles((int) points, (int) count, textured);
        for (Instance instance : instances) {
            triangles.add(instance.mesh, instance.world, surfaceNumbers(instance));
        }
        return triangles;
    }

    private void checkBudget(long triangles, long points) throws SceneFormatException {
        if (triangles > options.maxTriangles() || points > Integer.MAX_VALUE / 3 - 8) {
            throw notes.error("", "at most " + options.maxTriangles() + " triangles", String.valueOf(triangles));
        }
        long bytes = triangles * TRIANGLE_BYTES + points * POINT_BYTES;
        if (bytes > Runtime.getRuntime().maxMemory() / 2) {
            throw notes.error("", "a scene that fits in half of " + (Runtime.getRuntime().maxMemory() >> 20) + " MiB",
                    triangles + " triangles of " + points + " points");
        }
    }

    private int[] surfaceNumbers(Instance instance) {
        List<SurfaceValues> used = instance.mesh.surfaces();
        int[] numbers = new int[used.size()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = surfaces.index(instance.file, used.get(i));
        }
        return numbers;
    }
}
