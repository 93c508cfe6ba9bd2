package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.accuracy.CieCase.Measured;
import radiosity.input.photometry.Photometry;
import radiosity.output.points.Points;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Solution;
import radiosity.testkit.Cells;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * CIE 171:2006 with luminaires' files, in lm, lx and cd; errors in per cent of a case's largest value.
 *
 * <p>5.2: a point that shines as a Lambertian surface, I = I0 cos: E = I0 h² / d⁴ on a plane h below. 5.3: the lamp of 1 m
 * x 1 m and 1000 cd/m² as a luminaire with that luminous opening, in closed form as in {@link Cie}. 5.4: what an even
 * point of 10,000 lm sends into a room arrives; through an opening that is seen under the solid angle O, 10,000 lm O / (4
 * pi) leave, of the square of side 2 a at a distance h O = 4 asin(a² / (a² + h²)). 5.6: a reflector under a light that
 * comes straight down, E_hz = 1000 lx.
 */
@Tag("slow")
class CiePhotometryTest {

    private static final Surface BLACK = RoomScenes.grey("black", 0, 0);
    private static final Surface OPEN = RoomScenes.grey("opening", 0, 0);
    private static final Vec3 DOWN = new Vec3(0, 0, -1);
    private static final Vec3 UP = new Vec3(0, 0, 1);
    private static final Vec3 DEEP = new Vec3(0, 1, 0);
    private static final Units LUX = new Units(1, true);

    static List<CieCase> cases() throws IOException {
        return List.of(point(), area(), lit());
    }

    /** A file of 1000 cd straight down, with the cosine or the same in all directions. */
    private static Light luminaire(boolean even, double side, Vec3 place) throws IOException {
        StringBuilder file = new StringBuilder("IES:LM-63-2019\n[LUMINAIRE] made here\nTILT=NONE\n1 -1 1 181 1 1 2 " + side
                + " " + side + " 0\n1 1 0\n");
        for (int g = 0; g <= 180; g++) {
            file.append(g).append(g % 10 == 0 ? '\n' : ' ');
        }
        file.append("\n0\n");
        for (int g = 0; g <= 180; g++) {
            file.append(even ? 1000 : 1000 * Math.max(0, Math.cos(Math.toRadians(g)))).append('\n');
        }
        return Photometry.of(file.toString().getBytes(StandardCharsets.US_ASCII), "made.ies").at("lamp", place, DOWN,
                new Vec3(1, 0, 0), Rgb.grey(1), 1);
    }

    private static CieCase point() throws IOException {
        Scene scene = new SceneBuilder().polygon(BLACK, new Vec3(0, 0, 0), new Vec3(4, 0, 0), new Vec3(4, 4, 0),
                new Vec3(0, 4, 0)).light(luminaire(false, 0, new Vec3(2, 2, 3))).scene("5.2");
        List<Measured> points = new ArrayList<>();
        double[][] offsets = {{0, 0}, {.5, 0}, {1, 0}, {1.5, 0}, {.5, .5}, {1, .5}, {1.5, .5}, {1, 1}, {1.5, 1},
            {1.5, 1.5}};
        for (double[] o : offsets) {
            double square = o[0] * o[0] + o[1] * o[1] + 9;
            points.add(new Measured(String.valueOf((char) ('A' + points.size())), new Vec3(2 + o[0], 2 + o[1], 0), UP,
                    1000 * 9 / (square * square)));
        }
        return new CieCase("5.2 point source", scene.with(LUX), points);
    }

    private static CieCase area() throws IOException {
        double[] planes = {0, 4};
        Scene room = new Cells(planes, planes, new double[] {0, 3}).room("5.3", (i, j, k) -> true,
                (i, j, k, face) -> BLACK);
        CieCase exact = Cie.areaLamp();
        return new CieCase("5.3 area source of a file", room.with(room.surfaces(),
                List.of(luminaire(false, 1, new Vec3(2, 2, 3)))).with(LUX), exact.points());
    }

    private static CieCase lit() {
        CieCase emitting = Cie.reflectorAndWall(4);
        Light sky = new Light("E_hz", Light.Kind.DISTANT, Rgb.grey(1000), Vec3.ZERO, DOWN, Vec3.ZERO, Vec3.ZERO, 1, 0, 0);
        List<Surface> surfaces = emitting.scene().surfaces().stream()
                .map(s -> RoomScenes.grey(s.name(), 0, s.reflectance().r())).toList();
        return new CieCase("5.6 lit reflector", emitting.scene().with(surfaces, List.of(sky)).with(LUX),
                emitting.points().stream().map(p -> new Measured(p.name(), p.position(), p.normal(),
                        3 * p.irradiance())).toList());
    }

    @ParameterizedTest
    @MethodSource("cases")
    void everyPoint_isWithinTwoPerCentOfTheLargest(CieCase test) {
        check(test, Solve.byDefault(), 0.02);
    }

    @ParameterizedTest
    @MethodSource("cases")
    void everyPoint_isWithinHalfAPerCentWhereAFifthIsAsked(CieCase test) {
        check(test, Solve.byDefault().settings(RadiositySettings.defaults().accurate(0.002)), 0.005);
    }

    static void check(CieCase test, Solve solve, double within) {
        Points found = new Points(solve.solution(test.scene()));
        double worst = 0;
        String at = "";
        for (Measured p : test.points()) {
            double off = Math.abs(found.at(p.position(), p.normal()).irradiance().r() - p.irradiance()) / test.largest();
            at = off > worst ? p.name() : at;
            worst = Math.max(worst, off);
        }
        System.out.printf("CIE 171, %s: worst point %s, %.2f %% of the largest (%.1f asked)%n", test, at, 100 * worst,
                100 * within);
        assertTrue(worst <= within, at + " is off by " + worst);
    }

    /** The same without the triangles of a surface. */
    static Scene without(Surface opening, Scene scene) {
        SceneBuilder builder = new SceneBuilder();
        for (int t = 0; t < scene.triangles(); t++) {
            if (!scene.surface(t).equals(opening)) {
                builder.polygon(scene.surface(t), scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2));
            }
        }
        return builder.scene(scene.name());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void fluxOfAPoint_arrivesButForTheOpening(double half) throws IOException {
        double[] x = half == 0 ? new double[] {0, 4} : new double[] {0, 2 - half, 2 + half, 4};
        Scene room = new Cells(x, x, new double[] {0, 3}).room("5.4", (i, j, k) -> true,
                (i, j, k, face) -> half > 0 && face == 5 && i == 1 && j == 1 ? OPEN : BLACK);
        Scene open = without(OPEN, room);
        Scene scene = open.with(open.surfaces(), List.of(luminaire(true, 0, new Vec3(2, 2, 1.5)))).with(LUX);
        double emitted = 4 * Math.PI * 1000;
        double angle = 4 * Math.asin(half * half / (half * half + 2.25));
        Solution solution = Solve.byDefault().solution(scene);
        assertEquals(emitted - 1000 * angle, solution.scene().units().flux(solution.ledger().received()),
                0.005 * emitted);
    }
}
