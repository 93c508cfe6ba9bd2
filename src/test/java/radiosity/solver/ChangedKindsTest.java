package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.scene.ImageMap;
import radiosity.scene.Light;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.solution.SavedState;
import radiosity.testkit.Changing;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.Edits;

/** Scenes of other kinds than the coloured room: their light follows, too, or a line says why it does not. */
@Tag("slow")
class ChangedKindsTest {

    private static final Changing COARSE = new Changing(0.08);
    private static final Changing COARSEST = new Changing(0.2);
    private static final Scene ROOM = ColouredRoom.SCENE;
    /** Without its front, through which light comes in. */
    private static final Scene OPEN = Edits.without(ROOM, Edits.surface(ROOM, "wall 5"));
    private static final Vec3 UP = new Vec3(0, 1, 0);

    private static Scene blockMoved(Scene scene) {
        return Edits.moved(scene, Edits.surface(scene, "block"), new Vec3(-0.05, 0, 0.25));
    }

    private static Scene dimmed(Scene scene, double to) {
        return Edits.with(scene, "lamp", s -> new Surface(s.name(), Rgb.grey(to), s.reflectance(), false));
    }

    private static Scene lit(Scene scene, Light... lights) {
        return scene.with(scene.surfaces(), List.of(lights));
    }

    private static void assertAsAnew(Scene from, Scene... to) throws IOException {
        assertAsAnew(COARSE, from, to);
    }

    private static void assertAsAnew(Changing how, Scene from, Scene... to) throws IOException {
        SavedState old = how.anew(from).state();
        for (Scene scene : to) {
            how.assertAsAnew(scene, old);
        }
    }

    /*---- Lights without geometry ----*/

    private static Light light(Light.Kind kind, double power, Vec3 at) {
        return new Light("light", kind, Rgb.grey(power), at, new Vec3(0.1, -1, 0.3).unit(), Vec3.ZERO, Vec3.ZERO, 0.2,
                0.9, 0.3);
    }

    @Test
    void pointLight_comesMovesAndGoes() throws IOException {
        Scene lit = lit(ROOM, light(Light.Kind.POINT, 0.2, new Vec3(0.15, 0.4, 0.4)));
        assertAsAnew(lit, lit(ROOM, light(Light.Kind.POINT, 0.15, new Vec3(0.3, 0.45, 0.4))), ROOM, blockMoved(lit));
        assertAsAnew(ROOM, lit);
    }

    @Test
    void spot_movesAndTurnsIntoAPoint() throws IOException {
        assertAsAnew(lit(ROOM, light(Light.Kind.SPOT, 0.7, new Vec3(0.15, 0.4, 0.4))),
                lit(ROOM, light(Light.Kind.SPOT, 0.7, new Vec3(0.25, 0.5, 0.3))),
                lit(ROOM, light(Light.Kind.POINT, 0.4, new Vec3(0.15, 0.4, 0.4))));
    }

    @Test
    void sun_moves() throws IOException {
        Scene morning = lit(OPEN, Light.sun(new Vec3(0.3, 0.5, 1), 0.7));
        assertAsAnew(morning, lit(OPEN, Light.sun(new Vec3(0.2, 0.6, 1), 0.9)), blockMoved(morning));
    }

    @Test
    void sky_clears() throws IOException {
        assertAsAnew(COARSEST, lit(OPEN, Light.sky(Light.Kind.SKY_OVERCAST, 1, UP, UP)),
                lit(OPEN, Light.sky(Light.Kind.SKY_UNIFORM, 1.2, UP, UP)));
    }

    @Test
    void wallThatGoes_letsTheSkyIn() throws IOException {
        Light sky = Light.sky(Light.Kind.SKY_UNIFORM, 0.5, UP, UP);
        assertAsAnew(COARSEST, lit(ROOM, sky), lit(OPEN, sky));
    }

    /*---- Layers ----*/

    @Test
    void layers_changeEachForItself() throws IOException {
        Changing layered = new Changing(COARSE.error(), COARSE.settings().layers(true));
        Light point = light(Light.Kind.POINT, 0.7, new Vec3(0.15, 0.4, 0.4));
        Scene room = lit(ROOM, point);
        SavedState old = layered.anew(room).state();
        layered.assertAsAnew(blockMoved(room), old);
        layered.assertAsAnew(dimmed(room, 0.6), old);
        layered.assertAsAnew(lit(room, light(Light.Kind.POINT, 0.7, new Vec3(0.3, 0.45, 0.4))), old);
        assertEquals("lamps or colours have come or gone that light is kept apart for",
                layered.obstacle(ROOM, old));
    }

    /*---- Images ----*/

    /** Of two pixels, over a wall and a lamp. */
    private static Scene painted(float left, float right, float glow) {
        List<Surface> surfaces = ROOM.surfaces().stream().map(s -> switch (s.name()) {
            case "wall 4" -> s.with(new Surface.Maps(Optional.empty(), image(left, right, .5f)));
            case "lamp" -> s.with(new Surface.Maps(image(glow, 1, .8f), Optional.empty()));
            default -> s;
        }).toList();
        float[] places = new float[6 * ROOM.triangles()];
        for (int i = 0; i < places.length; i++) {
            places[i] = i * 7 % 5 / 4f;
        }
        return new Scene(ROOM.name(), ROOM.points(), ROOM.corners(), ROOM.surfaceOf(), surfaces, List.of(),
                ROOM.camera(), places);
    }

    private static Optional<Raster> image(float left, float right, float blue) {
        return Optional.of(new Raster(2, 1, new float[] {left, left, blue, right, right, blue}, ImageMap.Wrap.REPEAT,
                ImageMap.Wrap.REPEAT, Rgb.BLACK));
    }

    @Test
    void images_change() throws IOException {
        Scene old = painted(.9f, .1f, .5f);
        assertAsAnew(old, painted(.2f, .8f, .5f), painted(.9f, .1f, .8f), blockMoved(old));
    }

    @Test
    void imagesComeAndGo() throws IOException {
        assertAsAnew(painted(.9f, .1f, .8f), dimmed(ROOM, 0.9));
        assertAsAnew(ROOM, painted(.9f, .1f, .8f));
    }

    /*---- Schedules ----*/

    @Test
    void otherSchedules_areRenderedAnewAndSaySo() throws IOException {
        for (Schedule schedule : Schedule.values()) {
            if (schedule != Schedule.PREDICT) {
                Changing paper = new Changing(COARSE.error(), new RadiositySettings(ROOM.area() / 120, 1,
                        Double.POSITIVE_INFINITY, schedule));
                assertEquals("only solutions of --schedule predict and --form-factors raycast are changed",
                        paper.obstacle(blockMoved(ROOM), SavedState.NONE));
            }
        }
    }
}
