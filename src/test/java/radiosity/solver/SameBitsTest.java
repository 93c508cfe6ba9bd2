package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.protocol.SceneBytes;
import radiosity.protocol.Wire;
import radiosity.scene.ImageMap;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.testkit.ColouredRoom;

/**
 * The law of the house: the answer is the same to the last bit on any number of threads and partitions, and through a
 * stop and a resumption.
 */
@Tag("slow")
public class SameBitsTest {

    public static final Scene SCENE = ColouredRoom.SCENE;

    public static RadiositySettings settings(Schedule schedule) {
        double meshing = schedule == Schedule.PAPER ? 0.1 : Double.POSITIVE_INFINITY;
        return new RadiositySettings(SCENE.area() / 120, 1, meshing, schedule, 0.3, 2e-3);
    }

    public static Solution solve(World world, StopRule stop) throws IOException {
        ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, stop);
        rounds.run(progress -> true);
        return rounds.solution();
    }

    public static StopRule shots(int n) {
        return new StopRule(n, 1e-3);
    }

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void dealtWorld_givesTheSameBitsAsLocal(Schedule schedule) throws IOException {
        Solution local = solve(new LocalWorld(SCENE, settings(schedule), 1), shots(250));
        assertTrue(local.elements() > 200, "the mesh was subdivided");
        assertSame(local, solve(new LocalWorld(SCENE, settings(schedule), 2, 1), shots(250)));
        assertSame(local, solve(new LocalWorld(SCENE, settings(schedule), 1, 3), shots(250)));
        assertSame(local, solve(new LocalWorld(SCENE, settings(schedule), 2, 7), shots(250)));
    }

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void resumed_givesTheSameBitsAsAtOnce(Schedule schedule) throws IOException {
        Solution atOnce = solve(new LocalWorld(SCENE, settings(schedule), 2), shots(250));
        int half = atOnce.shots() / 2 + 1;
        Solution first = solve(new LocalWorld(SCENE, settings(schedule), 2), shots(half));
        assertEquals(half, first.shots());
        ProgressiveRadiosity rest = new ProgressiveRadiosity(new LocalWorld(SCENE, settings(schedule), 1, 3),
                shots(250));
        rest.resume(first.state());
        rest.run(progress -> true);
        assertSame(atOnce, rest.solution());
    }

    /** Neighbouring faces are in one plane, as far as that can be told, but those at the ends are not. */
    @Test
    void bentSurface_givesTheSameBitsDealt() throws IOException {
        Scene bent = bent();
        RadiositySettings settings = new RadiositySettings(bent.area() / 200, 1, Double.POSITIVE_INFINITY,
                Schedule.PAPER);
        Solution local = solve(new LocalWorld(bent, settings, 1), shots(20));
        for (int parts : new int[] {2, 3, 5}) {
            assertSame(local, solve(new LocalWorld(bent, settings, 1, parts), shots(20)));
        }
    }

    /** A strip of 60 rectangles, each turned by 5e-5 against the last, below a lamp. */
    private static Scene bent() {
        SceneBuilder builder = new SceneBuilder();
        Surface strip = new Surface("strip", Rgb.BLACK, Rgb.grey(0.7), false);
        Vec3 from = Vec3.ZERO;
        for (int i = 0; i < 60; i++) {
            double angle = 5e-5 * i;
            Vec3 to = from.plus(new Vec3(0.1 * StrictMath.cos(angle), 0.1 * StrictMath.sin(angle), 0));
            Vec3 side = new Vec3(0, 0, 0.3);
            builder.polygon(strip, from, from.plus(side), to.plus(side), to);
            from = to;
        }
        builder.polygon(new Surface("lamp", Rgb.grey(1), Rgb.grey(0.5), false), new Vec3(2, 1, 0), new Vec3(4, 1, 0),
                new Vec3(4, 1, 0.3), new Vec3(2, 1, 0.3));
        return builder.scene("bent strip");
    }

    @Test
    void layers_areTheSameBitsDealtAndResumed() throws IOException {
        RadiositySettings layered = settings(Schedule.PREDICT).layers(true);
        Scene two = twoLamps();
        Solution local = solve(new LocalWorld(two, layered, 2), shots(250));
        assertEquals(2, local.layers());
        assertSame(local, solve(new LocalWorld(two, layered, 1, 3), shots(250)));
        Solution first = solve(new LocalWorld(two, layered, 2), shots(local.shots() / 2));
        ProgressiveRadiosity rest = new ProgressiveRadiosity(new LocalWorld(two, layered, 1, 3), shots(250));
        rest.resume(first.state());
        rest.run(progress -> true);
        assertSame(local, rest.solution());
    }

    /** Besides the block the ceiling glows, and in another colour. */
    private static Scene twoLamps() {
        List<Surface> surfaces = new ArrayList<>(SCENE.surfaces());
        surfaces.set(3, new Surface("ceiling", new Rgb(0.1, 0, 0.2), Rgb.grey(0.4), false));
        return new Scene(SCENE.name(), SCENE.points(), SCENE.corners(), SCENE.surfaceOf(), surfaces, List.of(),
                SCENE.camera());
    }

    @Test
    void images_reachOtherHostsWithTheScene() throws IOException {
        Scene painted = painted();
        SceneBytes.Task sent = SceneBytes.read(Wire.input(SceneBytes.write(painted,
                settings(Schedule.PREDICT))));
        Solution here = solve(new LocalWorld(painted, settings(Schedule.PREDICT), 2), shots(100));
        assertSame(here, solve(new LocalWorld(sent.scene(), sent.settings(), 1, 3), shots(100)));
        Solution plain = solve(new LocalWorld(SCENE, settings(Schedule.PREDICT), 2), shots(100));
        assertNotEquals(plain.unshotFlux(), here.unshotFlux(), "the image matters");
    }

    /** One wall has a picture of two pixels. */
    private static Scene painted() {
        Raster raster = new Raster(2, 1, new float[] {.9f, .1f, .2f, .1f, .5f, .7f}, ImageMap.Wrap.REPEAT,
                ImageMap.Wrap.NONE, Rgb.grey(.3));
        List<Surface> surfaces = new ArrayList<>(SCENE.surfaces());
        surfaces.set(1, surfaces.get(1).with(new Surface.Maps(Optional.empty(), Optional.of(raster))));
        float[] places = new float[6 * SCENE.triangles()];
        for (int i = 0; i < places.length; i++) {
            places[i] = i * 7 % 5 / 4f;
        }
        return new Scene(SCENE.name(), SCENE.points(), SCENE.corners(), SCENE.surfaceOf(), surfaces, List.of(),
                SCENE.camera(), places);
    }

    /** Hosts on JDK 17 and on JDK 25 compare it; JDK 17 has 1.9999999999999998E23 for this number. */
    @Test
    void fingerprint_hasTheSameDigitsOnEveryJdk() {
        RadiositySettings settings = new RadiositySettings(SCENE.area() / 120, 1, 2e23, Schedule.PAPER);
        String fingerprint = new LocalWorld(SCENE, settings, 1).mesh.fingerprint();
        assertTrue(fingerprint.contains(" -mt 2.0E23 "), fingerprint);
    }

    @Test
    void ledger_closes() throws IOException {
        for (Schedule schedule : Schedule.values()) {
            Solution solution = solve(new LocalWorld(SCENE, settings(schedule), 2), shots(200));
            assertEquals(0, solution.ledger().imbalance(0), 1e-12);
            assertTrue(solution.ledger().shot()[0] > 0);
        }
    }
}
