package radiosity.solver;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.DoubleStream;
import radiosity.change.Relight;
import radiosity.change.SceneChange;
import radiosity.protocol.Order;
import radiosity.protocol.SavedScene;
import radiosity.protocol.SceneBytes;
import radiosity.protocol.Wire;
import radiosity.scene.Vec3;
import radiosity.setup.InitialMesh;
import radiosity.solution.SavedState;

/** Starts a calculation from the solution of an earlier scene, or says why that solution cannot be used. */
final class EditedScene {

    /** Largest part of the scene's area that may have been added or removed. */
    private static final double MOST_AREA = 0.5;
    /** Unshot flux over emitted flux, after the edit, above which rendering anew costs less. */
    private static final double MOST_UNSHOT = 0.7;

    private final World world;
    private final SavedState earlier;
    private InitialMesh before;
    private SceneChange change;

    /** @param before initial mesh of the earlier scene, or null: then the mesh is made from the saved scene */
    EditedScene(World world, SavedState earlier, InitialMesh before) {
        this.world = world;
        this.earlier = earlier;
        this.before = before;
    }

    /** Why the light of the earlier scene cannot be used, in a few words; empty where it can. */
    Optional<String> obstacle() throws IOException {
        if (!world.mesh.predicts() || !world.mesh.shootsClusters()) {
            return Optional.of("only solutions of --schedule predict and --form-factors raycast are changed");
        }
        Optional<SceneBytes.Task> task = before != null ? Optional.empty()
                : SavedScene.read(earlier::open, earlier.length());
        if (before == null && task.isEmpty()) {
            return Optional.of("the old file does not hold its scene");
        }
        if (!task.map(SceneBytes.Task::settings).orElse(world.settings()).equals(world.settings())) {
            return Optional.of("the old solution was made with other settings");
        }
        before = before != null ? before : new InitialMesh(task.get().scene(), task.get().settings());
        InitialMesh now = world.mesh;
        if (!before.fingerprint().equals(fingerprint())) {
            return Optional.of("another version of the program made the old solution");
        }
        if (before.faces.size() != now.faces.size()
                || !before.faces.unit(Vec3.ZERO).equals(now.faces.unit(Vec3.ZERO))) {
            return Optional.of("the extent of the scene has changed");
        }
        if (before.faces.channels() != now.faces.channels() || before.faces.layers() != now.faces.layers()) {
            return Optional.of("lamps or colours have come or gone that light is kept apart for");
        }
        change = new SceneChange(before, now);
        double changed = change.share();
        return changed <= MOST_AREA ? Optional.empty()
                : Optional.of(Math.round(100 * changed) + " % of all area has come or gone");
    }

    private String fingerprint() throws IOException {
        try (DataInputStream in = new DataInputStream(earlier.open())) {
            return in.readUTF();
        }
    }

    /** Whether scene and settings are the same as before. */
    boolean isSame() throws IOException {
        return fingerprint().equals(world.mesh.fingerprint());
    }

    /**
     * Takes over the light of the earlier scene.
     *
     * @return why that light cannot be used; empty where it was taken over
     */
    Optional<String> begin(SolveCounters counters, Prediction planner, BooleanSupplier goOn) throws IOException {
        SolveCounters old = new SolveCounters(before, world.parallel);
        List<byte[]> blocks = new ArrayList<>();
        Optional<Prediction.EarlierEnd> prediction;
        try (DataInputStream in = new DataInputStream(earlier.open())) {
            in.readUTF();
            old.read(in);
            prediction = planner.readChanged(in, before);
            RoundQueue queue = new RoundQueue();
            queue.read(in);
            if (prediction.isEmpty() || !queue.isEmpty()) {
                return Optional.of("the old solution was stopped before its end");
            }
            for (int b = 0; b < before.blocks.size(); b++) {
                blocks.add(Wire.bytes(in));
            }
        }
        Relight relight = new Relight(before, world.mesh, change, world.parallel, goOn);
        Order.Rules rules = prediction.get().rules();
        List<byte[]> changed = relight.blocks(blocks, prediction.get().isSettled(), rules, planner.weight());
        double[] lights = !change.isOfGeometry() && !change.isOfLights() ? old.flux.lights()
                : world.mesh.isLitFromOutside() ? relight.lights() : world.mesh.lightFlux();
        double emitted = DoubleStream.of(world.mesh.emitted).sum() + DoubleStream.of(lights).sum();
        double unshot = relight.unshot();
        if (!(unshot <= MOST_UNSHOT * emitted)) {
            return Optional.of(emitted > 0 ? "light has changed by " + Math.round(100 * unshot / emitted)
                    + " % of what is emitted" : "nothing emits light");
        }
        world.restore(changed);
        counters.change(old, change.isOfGeometry(), relight.shot(), world.totals(), lights);
        return Optional.empty();
    }
}
