package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.edit.LightDifference;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Certificate;
import radiosity.solution.Solution;
import radiosity.testkit.Box;
import radiosity.testkit.Changing;
import radiosity.testkit.Edits;
import radiosity.testkit.RoomScenes;

/**
 * The certificate of a changed solution holds as that of a render anew does, in a furnished room of 4 x 2.5 x 3 m with
 * two lamps.
 *
 * <p>Two solutions whose errors are e and f differ by e + f at most, so a change must be within the sum of both
 * certificates of the render anew. The true error is the difference from a render of a fifth of the error, whose own
 * error adds a fiftieth to it, as squares add. The certificate over the true error may be from .7 to 1.5, as both are
 * means over points, of which a few bright ones decide.
 */
@Tag("slow")
class FurnishedRoomChangeTest {

    private static final double ERROR = 0.1;
    private static final int POINTS = 4000;
    private static final Scene ROOM = room();
    private static final Certified OLD = certified(ROOM, ERROR, null);

    private record Certified(Solution solution, Certificate certificate) { }

    /*---- The room ----*/

    private static Surface paint(String name, double r, double g, double b) {
        return new Surface(name, Rgb.BLACK, new Rgb(r, g, b), false);
    }

    private static Scene room() {
        SceneBuilder builder = new SceneBuilder();
        Box walls = new Box(Vec3.ZERO, new Vec3(4, 2.5, 3));
        List<Surface> of = List.of(paint("west", .7, .68, .6), paint("east", .7, .68, .6), paint("floor", .4, .3, .2),
                paint("ceiling", .8, .8, .8), paint("north", .3, .45, .5), paint("south", .7, .68, .6));
        IntStream.range(0, 6).forEach(side -> builder.polygon(of.get(side), walls.inside(side)));
        table(builder, paint("table", .5, .35, .2), 1.2, .7, 2.6, 1.4, .74);
        Surface chair = paint("chair", .6, .2, .15);
        table(builder, chair, 1.7, 1.3, 2.15, 1.75, .46);
        block(builder, chair, 1.7, .46, 1.71, 2.15, .9, 1.75);
        block(builder, paint("cupboard", .55, .5, .4), 3.5, 0, 1.2, 4, 1.8, 2.2);
        block(builder, RoomScenes.grey("ceiling lamp", 40, .5), 1.7, 2.3, 1.2, 2.3, 2.34, 1.8);
        block(builder, paint("pole", .3, .3, .3), .58, 0, 2.28, .62, 1.4, 2.32);
        block(builder, new Surface("shade", new Rgb(14, 11, 8), Rgb.grey(.5), false), .45, 1.4, 2.15, .75, 1.7, 2.45);
        return builder.scene("furnished room");
    }

    /** A top on four legs. */
    private static void table(SceneBuilder builder, Surface of, double x, double z, double toX, double toZ, double y) {
        block(builder, of, x, y - .04, z, toX, y, toZ);
        for (int leg = 0; leg < 4; leg++) {
            double atX = leg % 2 == 0 ? x : toX - .04;
            double atZ = leg < 2 ? z : toZ - .04;
            block(builder, of, atX, 0, atZ, atX + .04, y - .04, atZ + .04);
        }
    }

    private static void block(SceneBuilder builder, Surface of, double x, double y, double z, double toX, double toY,
                              double toZ) {
        Box box = new Box(new Vec3(x, y, z), new Vec3(toX, toY, toZ));
        for (int side = 0; side < 6; side++) {
            List<Vec3> corners = new ArrayList<>(List.of(box.inside(side)));
            Collections.reverse(corners);
            builder.polygon(of, corners.toArray(Vec3[]::new));
        }
    }

    private static Scene edited(String edit) {
        return switch (edit) {
            case "chair moved" -> Edits.moved(ROOM, Edits.surface(ROOM, "chair"), new Vec3(.3, 0, .95));
            case "wall repainted" -> Edits.with(ROOM, "north", s -> paint(s.name(), .7, .3, .2));
            case "lamp moved" -> Edits.moved(ROOM, t -> List.of("pole", "shade").contains(ROOM.surface(t).name()),
                    new Vec3(.1, 0, -1));
            case "cupboard removed" -> Edits.without(ROOM, Edits.surface(ROOM, "cupboard"));
            default -> throw new IllegalArgumentException(edit);
        };
    }

    /*---- Its light ----*/

    private static Certified certified(Scene scene, double error, Solution from) {
        try (LocalWorld world = new LocalWorld(scene, RadiositySettings.defaults().accurate(error), 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, Changing.STOP);
            if (from != null) {
                assertEquals(Optional.empty(), radiosity.change(from.state()));
            }
            radiosity.run(progress -> true);
            return new Certified(radiosity.solution(), radiosity.certificate(2).orElseThrow());
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"chair moved", "wall repainted", "lamp moved", "cupboard removed"})
    void change_isWithinBothCertificatesAndItsOwnHolds(String edit) {
        Scene scene = edited(edit);
        double[] places = LightDifference.places(scene, POINTS);
        Certified changed = certified(scene, ERROR, OLD.solution);
        Certified anew = certified(scene, ERROR, null);
        double[] light = LightDifference.radiosity(changed.solution, places);
        double difference = LightDifference.of(LightDifference.radiosity(anew.solution, places), light);
        double both = changed.certificate.expected() + anew.certificate.expected();
        assertTrue(difference <= both, difference + " is more than the sum of both certificates, " + both);

        Solution truth = certified(scene, ERROR / 5, null).solution;
        double error = LightDifference.of(LightDifference.radiosity(truth, places), light);
        double ratio = changed.certificate.expected() / error;
        assertTrue(ratio >= 0.7 && ratio <= 1.5, "certificate over true error: " + ratio + ", error " + error);
    }
}
