package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.FormFactorCalculators;
import radiosity.scene.Vec3;
import radiosity.settings.FormFactors;
import radiosity.testkit.Calculated;
import radiosity.testkit.SharedData;

/**
 * What every {@link FormFactorCalculator} owes, each within its bounds: the form factors of {@code
 * truth/formfactors.json}, and those of two unit squares in closed form (J. R. Howell, A catalog of radiation heat
 * transfer configuration factors, C-11 and C-14).
 *
 * <p>From an area it is the mean over 100 points, which themselves leave an error of up to 4e-3 near a surface. The
 * paper's rays have no bound there: they are held to places half a polygon's size away or more, where of 2,000 random
 * rays four standard errors are 4 sqrt((max k / mean k - 1) / 2000) F, about F / 10.
 */
@Tag("slow")
class FormFactorContractTest {

    private static final int POINTS = 100;
    private static final int PLAIN_RAYS = 2000;

    /** Absolute errors of one point, and of a mean over points; with so many rays. */
    private record Bounds(double point, double area, int rays) { }

    private static final Map<FormFactors, Bounds> BOUNDS = Map.of(
            FormFactors.RAYCAST, new Bounds(5e-6, 5e-3, 4),
            FormFactors.PLAIN, new Bounds(0.02, 8e-3, PLAIN_RAYS),
            FormFactors.HEMICUBE, new Bounds(2e-3, 6e-3, FormFactorCalculators.defaultRays(FormFactors.HEMICUBE, 0)),
            FormFactors.NUSSELT, new Bounds(5e-3, 6e-3, FormFactorCalculators.defaultRays(FormFactors.NUSSELT, 0)));

    private static final Vec3[] FLOOR = square(0, false);
    private static final Vec3[] CEILING = square(1, true);
    private static final Vec3[] WALL = {new Vec3(0, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 1, 1), new Vec3(0, 0, 1)};
    private static final Vec3 MIDDLE = new Vec3(0.5, 0.5, 0);
    private static final Vec3 UP = new Vec3(0, 0, 1);

    /** A horizontal unit square. */
    private static Vec3[] square(double z, boolean down) {
        Vec3 b = new Vec3(1, 0, z);
        Vec3 d = new Vec3(0, 1, z);
        return new Vec3[] {new Vec3(0, 0, z), down ? d : b, new Vec3(1, 1, z), down ? b : d};
    }

    @ParameterizedTest
    @EnumSource(FormFactors.class)
    void formFactorsFromPoints_areTheReferences(FormFactors kind) {
        for (JsonNode c : SharedData.cases("formfactors.json")) {
            if (c.has("point") && isFarEnough(kind, c)) {
                Calculated to = Calculated.of(c);
                double found = to.from(calculator(to, kind), SharedData.vector(c.get("point")),
                        SharedData.vector(c.get("normal")), 7);
                assertEquals(c.get("F12").asDouble(), found, BOUNDS.get(kind).point(), c.get("id").asText());
            }
        }
    }

    @ParameterizedTest
    @EnumSource(FormFactors.class)
    void formFactorsFromAreas_areTheReferences(FormFactors kind) {
        for (JsonNode c : SharedData.cases("formfactors.json")) {
            if (c.has("polygon1") && isFarEnough(kind, c)) {
                Calculated to = Calculated.of(c);
                double found = to.from(calculator(to, kind), SharedData.polygon(c.get("polygon1")), POINTS);
                assertEquals(c.get("F12").asDouble(), found, BOUNDS.get(kind).area(), c.get("id").asText());
            }
        }
    }

    private static FormFactorCalculator calculator(Calculated to, FormFactors kind) {
        return to.calculator(kind, BOUNDS.get(kind).rays());
    }

    /**
     * For the paper's rays: corners and middle of polygon 2 are farther than half its diagonal from the other's
     * corners.
     */
    private static boolean isFarEnough(FormFactors kind, JsonNode c) {
        Vec3[] to = SharedData.polygon(c.get("polygon2"));
        Vec3[] from = c.has("point") ? new Vec3[] {SharedData.vector(c.get("point"))}
                : SharedData.polygon(c.get("polygon1"));
        double nearest = Double.POSITIVE_INFINITY;
        double diagonal = 0;
        Vec3 middle = Arrays.stream(to).reduce(Vec3.ZERO, Vec3::plus).times(1.0 / to.length);
        for (Vec3 p : to) {
            for (Vec3 q : from) {
                nearest = Math.min(nearest, Math.min(p.minus(q).length(), middle.minus(q).length()));
            }
            diagonal = Math.max(diagonal, p.minus(to[0]).length());
        }
        return kind != FormFactors.PLAIN || nearest >= diagonal / 2;
    }

    @ParameterizedTest
    @EnumSource(FormFactors.class)
    void unitSquares_areHowells(FormFactors kind) {
        Calculated ceiling = new Calculated(CEILING, List.<Vec3[]>of(FLOOR));
        assertEquals(0.199824895698387, ceiling.from(calculator(ceiling, kind), FLOOR, POINTS), BOUNDS.get(kind)
                .area());
        Calculated wall = new Calculated(WALL, List.<Vec3[]>of(FLOOR));
        double bound = kind == FormFactors.PLAIN ? 0.05 : BOUNDS.get(kind).area();
        assertEquals(0.200043776075403, wall.from(calculator(wall, kind), FLOOR, POINTS), bound);
    }

    @ParameterizedTest
    @EnumSource(FormFactors.class)
    void behindOrBelowTheHorizon_nothingArrives(FormFactors kind) {
        Calculated fromBehind = new Calculated(square(1, false), List.of());
        assertEquals(0, fromBehind.from(calculator(fromBehind, kind), MIDDLE, UP, 1));
        Calculated below = new Calculated(CEILING, List.of());
        assertEquals(0, below.from(calculator(below, kind), MIDDLE, UP.times(-1), 1));
    }

    @ParameterizedTest
    @EnumSource(FormFactors.class)
    void behindABlocker_nothingArrives(FormFactors kind) {
        Vec3[] blocker = {new Vec3(-9, -9, 0.5), new Vec3(9, -9, 0.5), new Vec3(9, 9, 0.5), new Vec3(-9, 9, 0.5)};
        Calculated hidden = new Calculated(CEILING, List.<Vec3[]>of(blocker));
        assertEquals(0, hidden.from(calculator(hidden, kind), MIDDLE, UP, 1));
    }

    @ParameterizedTest
    @EnumSource(FormFactors.class)
    void sameReceiver_getsTheSameBits(FormFactors kind) {
        Calculated ceiling = new Calculated(CEILING, List.of());
        double once = ceiling.from(calculator(ceiling, kind), MIDDLE, UP, 5);
        assertEquals(once, ceiling.from(calculator(ceiling, kind), MIDDLE, UP, 5));
    }

    /** A whole sky is 1: half a cube is divided into cells without a rest, and so is a disc but for its border. */
    @Test
    void projections_fillTheSky() {
        Vec3[] sky = {new Vec3(-1e4, -1e4, 1), new Vec3(-1e4, 1e4, 1), new Vec3(1e4, 1e4, 1), new Vec3(1e4, -1e4, 1)};
        Calculated above = new Calculated(sky, List.of());
        for (FormFactors kind : List.of(FormFactors.HEMICUBE, FormFactors.NUSSELT)) {
            double found = above.from(calculator(above, kind), new Vec3(0, 0, -1), UP, 3);
            assertTrue(Math.abs(found - 1) < 3e-3, kind + " " + found);
        }
    }
}
