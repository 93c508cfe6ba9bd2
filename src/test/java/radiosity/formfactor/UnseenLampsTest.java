package radiosity.formfactor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import radiosity.input.assembly.LeftOut;
import radiosity.mesh.face.Faces;
import radiosity.scene.Lamp;
import radiosity.scene.Light;
import radiosity.scene.Luminaire;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.Box;
import radiosity.testkit.Cells;
import radiosity.testkit.RoomScenes;
import radiosity.visibility.RadiosityBounds;

/** Lamps in a room of edge 1 below a slab from y = 1 to 1.2. */
class UnseenLampsTest {

    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    private static List<String> unseen(SceneBuilder builder) {
        RoomScenes.addRoom(builder, RoomScenes.grey("room", 0, .5), Box.UNIT);
        RoomScenes.addSolid(builder, RoomScenes.grey("slab", 0, .5), new Vec3(-.1, 1, -.1), new Vec3(1.1, 1.2, 1.1));
        return unseen(builder.scene("room"));
    }

    private static List<String> unseen(Scene scene) {
        Faces faces = new Faces(scene);
        return new UnseenLamps(faces, new RadiosityBounds(faces.occluders()), EscapingLightTest.of(faces)).list()
                .stream().map(Lamp::name).toList();
    }

    private static Light light(Light.Kind kind, String name, double height, double power, double cone) {
        LuminousIntensity even = new LuminousIntensity(LuminousIntensity.Type.C, new double[] {0, 360},
                new double[] {0, 180}, new double[] {1, 1, 1, 1});
        return new Light(name, kind, Rgb.grey(power), new Vec3(.5, height, .5), DOWN, new Vec3(.1, 0, 0),
                new Vec3(0, 0, .1), 1, cone, .001, kind == Light.Kind.POINT
                ? Optional.of(new Luminaire(even, new Vec3(1, 0, 0), .1, .1)) : Optional.empty());
    }

    private static SceneBuilder lights(double height, double power) {
        return new SceneBuilder().light(light(Light.Kind.POINT, "luminaire", height, power, 1))
                .light(light(Light.Kind.SPOT, "spot", height, power, .01))
                .light(light(Light.Kind.AREA, "area", height, power, 1));
    }

    @Test
    void lightsInsideASlab_areUnseen() {
        assertEquals(List.of("luminaire", "spot", "area"), unseen(lights(1.05, 1)));
    }

    @Test
    void lightsBelowASlabOrInItsPlane_areSeen() {
        assertEquals(List.of(), unseen(lights(.9, 1)));
        assertEquals(List.of(), unseen(lights(1, 1)));
    }

    @Test
    void sunAndSky_areSeenThroughSmallWindowsOnly() throws IOException {
        double[] side = {0, .5, .53, 1};
        Surface wall = RoomScenes.grey("wall", 0, .5);
        Surface pane = RoomScenes.grey("pane", 0, .5);
        Scene closed = new Cells(side, side, side).room("room", (i, j, k) -> true,
                (i, j, k, face) -> face == 0 && j == 1 && k == 1 ? pane : wall);
        Vec3 up = new Vec3(0, 1, 0);
        closed = closed.with(closed.surfaces(), List.of(Light.sky(Light.Kind.SKY_OVERCAST, 1, up, up),
                new Light("sun", Light.Kind.DISTANT, Rgb.grey(1), Vec3.ZERO, new Vec3(1, -1, .5), Vec3.ZERO, Vec3.ZERO, 1,
                        0, 0)));
        assertEquals(List.of("sky", "sun"), unseen(closed));
        assertEquals(List.of(), unseen(LeftOut.of(closed, Set.of("pane"))));
    }

    @Test
    void lightsWithoutPower_areNotMissed() {
        assertEquals(List.of(), unseen(lights(1.05, 0)));
    }

    @Test
    void surfacesThatEmitTowardsTheCeiling_areUnseen() {
        assertEquals(List.of(), unseen(panel(new SceneBuilder(), true)));
        assertEquals(List.of("panel"), unseen(panel(new SceneBuilder(), false)));
    }

    private static SceneBuilder panel(SceneBuilder builder, boolean down) {
        Surface panel = RoomScenes.grey("panel", 1, .5);
        Vec3[] p = {new Vec3(.4, 1, .4), new Vec3(.6, 1, .4), new Vec3(.6, 1, .6), new Vec3(.4, 1, .6)};
        return down ? builder.polygon(panel, p) : builder.polygon(panel, p[3], p[2], p[1], p[0]);
    }
}
