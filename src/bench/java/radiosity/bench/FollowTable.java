package radiosity.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.function.DoubleFunction;
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

/**
 * Prints how fast light follows edits, see {@code scripts/change --help}: a line per edit. Edits come as from a user in
 * the window: the object, and the slider of the colour, are dragged for a second and let go; before each edit the user
 * looks at the picture for two seconds.
 */
public final class FollowTable {

    /** Number of mouse movements of a drag. */
    private static final int MOVEMENTS = 30;
    private static final long MOVEMENT_MILLIS = 33;
    private static final long LOOK_MILLIS = 2000;
    private static final Rgb PAINT = new Rgb(.6, .15, .1);

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
        try (LightFollower follower = new LightFollower(saved.state(), saved.settings(),
                Integer.parseInt(arguments[7]),
                solution -> LitScene.of(solution, DefaultCamera.of(solution)), // what the window does before it draws
                rests::add, System.out::println)) {
            Rests seen = new Rests(follower, rests);
            seen.follow("opened", scene);
            Rgb before = scene.surfaces().get(surface).reflectance();
            for (int round = 0; round < 2; round++) {
                seen.drag(history, part -> new Edit.Moved(node, Vec3.ZERO, 0, by.times(part)));
                history.undo();
                seen.follow("undone", history.scene());
                seen.drag(history, part -> new Edit.Painted(surface, mean(before, PAINT, part)));
                history.undo();
                seen.follow("undone", history.scene());
            }
        }
    }

    private static Rgb mean(Rgb from, Rgb to, double part) {
        return from.times(1 - part).plus(to.times(part));
    }

    private static int indexOf(List<String> names, String name) {
        int index = names.indexOf(name);
        if (index < 0) {
            throw new IllegalArgumentException("expected one of " + names + ", got " + name);
        }
        return index;
    }

    /** The follower, and what it says when the light is at rest. */
    private record Rests(LightFollower follower, BlockingQueue<LightFollower.Rest> rests) {

        /** Drags for a second and lets go; {@code part} makes the edit of a part of the way, in (0, 1]. */
        void drag(EditHistory history, DoubleFunction<Edit> part) throws InterruptedException {
            Thread.sleep(LOOK_MILLIS);
            for (int i = 1; i < MOVEMENTS; i++) {
                follower.follow(part.apply((double) i / MOVEMENTS).of(history.scene()), true);
                Thread.sleep(MOVEMENT_MILLIS);
            }
            Edit edit = part.apply(1);
            history.add(edit);
            await(edit.text(history.original()), history.scene());
        }

        void follow(String what, Scene scene) throws InterruptedException {
            Thread.sleep(LOOK_MILLIS);
            await(what, scene);
        }

        private void await(String what, Scene scene) throws InterruptedException {
            double begin = TruthTable.cpuSeconds();
            follower.follow(scene);
            LightFollower.Rest rest = rests.take();
            System.out.printf("%s: %s; %.2f CPU s%n", what, rest.text(), TruthTable.cpuSeconds() - begin);
        }
    }
}
