package radiosity.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.atomic.AtomicReference;
import radiosity.Radiosity;
import radiosity.cli.render.SavedCalculation;
import radiosity.edit.Edit;
import radiosity.edit.EditHistory;
import radiosity.edit.LightFollower;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.DefaultCamera;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/** Prints how fast light follows edits, see {@code scripts/change --help}: a line per edit. */
public final class FollowTable {

    private FollowTable() { }

    /** @param arguments scene file, its source, object, surface, x, y, z by which the object is moved, threads */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        SavedCalculation saved = SavedCalculation.read(Path.of(arguments[0]));
        Scene scene = Radiosity.read(Path.of(arguments[1]), line -> { });
        EditHistory history = new EditHistory(scene);
        int node = indexOf(scene.hierarchy().nodes().stream().map(n -> n.name()).toList(), arguments[2]);
        int surface = indexOf(scene.surfaces().stream().map(s -> s.name()).toList(), arguments[3]);
        Vec3 by = new Vec3(Double.parseDouble(arguments[4]), Double.parseDouble(arguments[5]),
                Double.parseDouble(arguments[6]));
        BlockingQueue<LightFollower.Rest> rests = new ArrayBlockingQueue<>(1);
        AtomicReference<Double> first = new AtomicReference<>();
        try (LightFollower follower = new LightFollower(saved.state(), saved.settings(),
                Integer.parseInt(arguments[7]), solution -> {
                    LitScene.of(solution, DefaultCamera.of(solution)); // what the window does before it draws
                    first.compareAndSet(null, TruthTable.cpuSeconds());
                }, rests::add, System.out::println)) {
            follow(follower, rests, first, "opened", scene);
            for (int round = 0; round < 2; round++) {
                history.add(new Edit.Moved(node, Vec3.ZERO, 0, by));
                follow(follower, rests, first, history.edits().get(0).text(scene), history.scene());
                history.undo();
                follow(follower, rests, first, "undone", history.scene());
                history.add(new Edit.Painted(surface, new Rgb(.6, .15, .1)));
                follow(follower, rests, first, history.edits().get(0).text(scene), history.scene());
                history.undo();
                follow(follower, rests, first, "undone", history.scene());
            }
        }
    }

    private static int indexOf(List<String> names, String name) {
        int index = names.indexOf(name);
        if (index < 0) {
            throw new IllegalArgumentException("expected one of " + names + ", got " + name);
        }
        return index;
    }

    private static void follow(LightFollower follower, BlockingQueue<LightFollower.Rest> rests,
            AtomicReference<Double> first, String what, Scene scene) throws InterruptedException {
        first.set(null);
        double begin = TruthTable.cpuSeconds();
        follower.follow(scene);
        LightFollower.Rest rest = rests.take();
        System.out.printf("%s: %s; first light %.2f CPU s, all %.2f CPU s%n", what, rest.text(), first.get() - begin,
                TruthTable.cpuSeconds() - begin);
    }
}
