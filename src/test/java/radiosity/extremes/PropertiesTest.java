package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.FormFactors;
import radiosity.solution.Solution;
import radiosity.testkit.Calculated;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.Moves;
import radiosity.testkit.Polyhedra;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * What holds in any scene, in random ones: closed polyhedra whose triangles have one of five surfaces that emit and
 * reflect at random. As furnaces they are in {@link WhiteFurnaceTest}.
 */
@Tag("slow")
public class PropertiesTest {

    private static final int SURFACES = 5;
    private static final double ROUNDING = 2e-6;
    /** Error at a point that is asked for; with a larger one a calculation may end a round before its equal. */
    private static final double ASKED = 0.01;
    /** Means over a surface, where an error of {@link #ASKED} at a point is asked for. */
    private static final double SAMPLING = 1e-3;

    public static Stream<Claim> claims() {
        return LongStream.range(100, 104).boxed().flatMap(seed -> Stream.of(
                Claim.of("linear in emission", "linear " + seed, () -> linear(seed)),
                Claim.of("reciprocity", "reciprocal " + seed, () -> reciprocal(seed)),
                Claim.of("turned", "turned " + seed, () -> same(seed, room -> Moves.turned(room, seed % 7))),
                Claim.of("reordered", "reordered " + seed, () -> same(seed, room -> Moves.reordered(room, seed)))));
    }

    @ParameterizedTest
    @MethodSource("claims")
    void randomScene_obeysTheLaw(Claim claim) {
        claim.check();
    }

    @ParameterizedTest
    @ValueSource(longs = {100, 101})
    void renamedSurfaces_giveTheSameBits(long seed) {
        Scene renamed = Moves.painted(room(seed, 0),
                s -> new Surface("other " + s.name(), s.exitance(), s.reflectance(),
                s.twoSided()));
        assertArrayEquals(solution(room(seed, 0)).irradiance(), solution(renamed).irradiance());
    }

    /** @param lamps which of the two sets of lamps are lit, as bits; 0: both */
    private static Scene room(long seed, int lamps) {
        Scene one = Polyhedra.random(seed, RoomScenes.grey("all", 1, 0.5));
        Random random = new Random(seed);
        List<Surface> surfaces = new ArrayList<>();
        for (int i = 0; i < SURFACES; i++) {
            boolean lit = lamps == 0 || (lamps >> i % 2 & 1) == 1;
            surfaces.add(new Surface("surface " + i, rgb(random).times(lit ? 1 : 0), rgb(random).times(0.9), false));
        }
        int[] surfaceOf = new int[one.triangles()];
        Arrays.setAll(surfaceOf, t -> t % SURFACES);
        return new Scene(one.name(), one.points(), one.corners(), surfaceOf, surfaces, one.lights(), one.camera());
    }

    private static Rgb rgb(Random random) {
        return new Rgb(random.nextDouble(), random.nextDouble(), random.nextDouble());
    }

    private static Solution solution(Scene room) {
        return Solve.byDefault().accurate(ASKED).solution(room);
    }

    /**
     * B(E1 + E2) = B(E1) + B(E2). In the paper's schedule form factors do not depend on what is shot, so it holds at
     * every vertex, but for what is left unshot.
     */
    private static Figure linear(long seed) {
        Solve paper = Solve.byDefault().paper().patches(room(seed, 0), 60).unsent(1e-7);
        double[] first = paper.solution(room(seed, 1)).irradiance();
        double[] second = paper.solution(room(seed, 2)).irradiance();
        double[] both = paper.solution(room(seed, 0)).irradiance();
        double worst = 0;
        for (int i = 0; i < both.length; i++) {
            worst = Math.max(worst, Math.abs(first[i] + second[i] - both[i]));
        }
        return new Figure("every vertex", ROUNDING, worst / Arrays.stream(both).max().orElseThrow());
    }

    /**
     * A1 F12 = A2 F21 of two random triangles with a third between; F from 10,000 points with the rays of the paper's
     * schedule.
     */
    private static Figure reciprocal(long seed) {
        Random random = new Random(seed);
        Vec3[] low = triangle(random, 0, 1, false);
        Vec3[] high = triangle(random, 1, 1, true);
        Vec3[] between = triangle(random, 0.5, 0.5, true);
        double there = exchange(low, high, between);
        double back = exchange(high, low, between);
        return Figure.relative("A F both ways", 1e-2, there, back);
    }

    private static double exchange(Vec3[] from, Vec3[] to, Vec3[] between) {
        Calculated factors = new Calculated(to, List.of(from, between));
        double area = from[1].minus(from[0]).cross(from[2].minus(from[0])).length() / 2;
        return area * factors.from(factors.calculator(FormFactors.RAYCAST, 4), from, 10_000);
    }

    /** Seen from above, or from below. */
    private static Vec3[] triangle(Random random, double height, double size, boolean down) {
        Vec3[] corners = new Vec3[3];
        double turn = random.nextDouble();
        for (int k = 0; k < 3; k++) {
            double angle = turn + (down ? -k : k) * 2 * Math.PI / 3 + 0.5 * random.nextDouble();
            corners[k] = new Vec3(size * Math.cos(angle), size * Math.sin(angle), height + 0.2 * random.nextDouble());
        }
        return corners;
    }

    /** The same means on all surfaces, but for what rays leave. */
    private static Figure same(long seed, UnaryOperator<Scene> change) {
        Scene room = room(seed, 0);
        Map<String, Rgb> before = means(solution(room));
        Map<String, Rgb> after = means(solution(change.apply(room)));
        double worst = 0;
        for (String name : before.keySet()) {
            for (int c = 0; c < 3; c++) {
                worst = Math.max(worst, Math.abs(after.get(name).channel(c) / before.get(name).channel(c) - 1));
            }
        }
        return new Figure("mean of each surface", SAMPLING, worst);
    }

    /** Mean irradiance by surface. */
    private static Map<String, Rgb> means(Solution solution) {
        Map<String, Rgb> flux = new TreeMap<>();
        Map<String, Double> area = new TreeMap<>();
        for (int e = 0; e < solution.elements(); e++) {
            Vec3[] p = new Vec3[3];
            Rgb sum = Rgb.BLACK;
            for (int k = 0; k < 3; k++) {
                int v = solution.corners()[3 * e + k];
                p[k] = new Vec3(solution.positions()[3 * v], solution.positions()[3 * v + 1],
                        solution.positions()[3 * v + 2]);
                sum = sum.plus(solution.irradianceAt(v));
            }
            double a = p[1].minus(p[0]).cross(p[2].minus(p[0])).length();
            flux.merge(solution.surface(e).name(), sum.times(a / 3), Rgb::plus);
            area.merge(solution.surface(e).name(), a, Double::sum);
        }
        flux.replaceAll((name, sum) -> sum.times(1 / area.get(name)));
        return flux;
    }
}
