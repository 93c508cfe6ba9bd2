package radiosity.output.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.output.gltf.Handmade;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

class ToneMappingTest {

    private static Solution room(double brightness, double lamp) {
        return handmade(brightness, lamp).solution();
    }

    private static Handmade handmade(double brightness, double lamp) {
        Handmade room = Handmade.room(Vec3.ZERO, 1, p -> new Rgb(1 + p.x(), 1 + p.y(), 1 + p.z()).times(brightness));
        room.grid(room.surface("lamp", Rgb.grey(lamp), Rgb.grey(.1), false), new Vec3(.4, .99, .4),
                new Vec3(.2, 0, 0), new Vec3(0, 0, .2), 1, 1, p -> Rgb.grey(brightness));
        return room;
    }

    private static double exposure(Solution solution) {
        return ToneMapping.automatic(solution).exposure();
    }

    @ParameterizedTest
    @EnumSource(ToneMapping.Operator.class)
    void moreLight_isNeverDarker_andStaysInRange(ToneMapping.Operator operator) {
        ToneMapping tones = new ToneMapping(operator, 2);
        assertEquals(Rgb.BLACK, tones.map(Rgb.BLACK));
        double last = 0;
        for (double light = 1e-6; light < 1e9; light *= 1.1) {
            double y = tones.map(Rgb.grey(light)).g();
            assertTrue(y >= last && y <= 1, light + " became " + y + " after " + last);
            last = y;
        }
        assertEquals(1, last);
    }

    @ParameterizedTest
    @EnumSource(ToneMapping.Operator.class)
    void anyLight_givesFiniteColours(ToneMapping.Operator operator) {
        ToneMapping tones = new ToneMapping(operator, 1e9);
        for (double light : new double[] {-1, -0.0, Double.MIN_VALUE, 1e300, Double.MAX_VALUE}) {
            Rgb colour = tones.map(new Rgb(light, 0, 1));
            for (int c = 0; c < 3; c++) {
                assertTrue(colour.channel(c) >= 0 && colour.channel(c) <= 1, light + " became " + colour);
            }
        }
    }

    @Test
    void reinhard_keepsTheHue() {
        Rgb colour = new ToneMapping(ToneMapping.Operator.REINHARD, 1).map(new Rgb(.6, .3, .15));
        assertEquals(2, colour.r() / colour.g(), 1e-12);
        assertEquals(4, colour.r() / colour.b(), 1e-12);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-12, 1, 1e12})
    void automaticExposure_followsTheScene(double brightness) {
        assertEquals(exposure(room(1, 50)), brightness * exposure(room(brightness, 50 * brightness)), 1e-9);
    }

    @Test
    void automaticExposure_doesNotCareForLamps() {
        assertEquals(exposure(room(1, 50)), exposure(room(1, 5000)), 1e-12);
    }

    @Test
    void automaticExposure_doesNotCareForOuterSidesOfWalls() {
        Handmade room = handmade(1, 50);
        room.grid(room.surface("outer side", .5), new Vec3(-.1, 0, 0), new Vec3(0, 9, 0), new Vec3(0, 0, 9), 4, 4,
                p -> Rgb.BLACK);
        assertEquals(exposure(room(1, 50)), exposure(room.solution()), 1e-12);
    }

    @Test
    void automaticExposure_bringsTheAverageToMiddleGrey() {
        Handmade wall = new Handmade();
        wall.grid(wall.surface("wall", .5), Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0), 3, 3, p -> Rgb.grey(8));
        assertEquals(.18 / 4, exposure(wall.solution()), 1e-12);
    }

    /** A wall before the camera, bright ground behind the eye, and a bright wall that turns its back. */
    @Test
    void automaticExposure_ofACamera_isThatOfWhatStandsBeforeIt() {
        Handmade scene = new Handmade();
        scene.grid(scene.surface("wall", .5), Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0), 3, 3, p -> Rgb.grey(8));
        scene.grid(scene.surface("ground", .5), new Vec3(-9, -1, 5), new Vec3(0, 0, 90), new Vec3(90, 0, 0), 3, 3,
                p -> Rgb.grey(800));
        scene.grid(scene.surface("back", .5), new Vec3(0, 0, -1), new Vec3(0, 1, 0), new Vec3(1, 0, 0), 3, 3,
                p -> Rgb.grey(800));
        Camera towards = new Camera(new Vec3(.5, .5, 2), new Vec3(0, 0, -1), new Vec3(0, 1, 0), .4, 1);
        Camera away = new Camera(new Vec3(.5, .5, 2), new Vec3(0, 0, 1), new Vec3(0, 1, 0), .4, 1);
        Camera up = new Camera(new Vec3(.5, .5, 2), new Vec3(0, 1, 0), new Vec3(0, 0, 1), .4, 1);

        Solution solution = scene.solution();
        assertEquals(.18 / 4, ToneMapping.automatic(solution, towards).exposure(), 1e-12);
        assertEquals(.18 / 400, ToneMapping.automatic(solution, away).exposure(), 1e-12);
        assertEquals(exposure(solution), ToneMapping.automatic(solution, up).exposure(), 1e-12);
    }

    @Test
    void stops_doubleTheExposure() {
        Solution room = room(1, 50);
        ToneMapping.Operator linear = ToneMapping.Operator.LINEAR;
        assertEquals(8 * ToneMapping.automatic(linear, room, Optional.empty(), 0).exposure(),
                ToneMapping.automatic(linear, room, Optional.empty(), 3).exposure(), 1e-12);
    }

    @Test
    void automaticExposure_withoutLightOrWithLampsOnly_isANumber() {
        assertEquals(1, exposure(room(0, 0)));
        assertEquals(1, exposure(new Handmade().solution()));
        Handmade lamp = new Handmade();
        lamp.grid(lamp.surface("lamp", Rgb.grey(40), Rgb.BLACK, false), Vec3.ZERO, new Vec3(1, 0, 0),
                new Vec3(0, 1, 0), 1, 1, p -> Rgb.BLACK);
        assertEquals(1 / 40., exposure(lamp.solution()), 1e-12);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void exposureThatIsNone_isRefused(double exposure) {
        assertThrows(IllegalArgumentException.class, () -> new ToneMapping(ToneMapping.Operator.LINEAR, exposure));
    }

    @Test
    void srgb_hasItsKnownValues() {
        assertEquals(0, ToneMapping.srgb(0));
        assertEquals(10, ToneMapping.srgb(0.003035));
        assertEquals(118, ToneMapping.srgb(0.18));
        assertEquals(188, ToneMapping.srgb(0.5));
        assertEquals(255, ToneMapping.srgb(1));
    }
}
