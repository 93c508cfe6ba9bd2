package radiosity.accuracy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.formfactor.ContourFactor;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.RayCaster;
import radiosity.scene.Vec3;
import radiosity.settings.FormFactors;
import radiosity.testkit.Calculated;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.NeedsReference;
import radiosity.testkit.Quadrature;
import radiosity.testkit.SharedData;

/**
 * The exact contour factor against form factors that were computed to 14 digits by others ({@code
 * truth/formfactors.json}), and what {@link RayCaster} finds with the number of rays that it has by default.
 *
 * <p>From a point the contour factor is compared as it is. From an area, F12 = 1/A1 times the integral over polygon 1
 * of the factor from its points to polygon 2; points behind polygon 2 receive nothing and are left out, for they would
 * put a kink into the integrand.
 *
 * <p>The ray caster is asked at {@value #POINTS} points of every triangle of polygon 1, spread evenly, as what is
 * hidden has kinks anywhere. With so many points the noise of its rays is below 1 % in the mean: where half of what is
 * behind is hidden, a ray's standard deviation is 1/2, and 1 / (2 sqrt({@value #POINTS})) = .5 %.
 */
@Tag("slow")
@NeedsReference("truth/formfactors.json")
public class FormFactorsTest {

    private static final String FILE = "formfactors.json";
    private static final int POINTS = 10_000;

    /** Of the exact factor. */
    public static Stream<Claim> contour() {
        return SharedData.cases(FILE).stream().filter(c -> !c.has("blockers")).map(c -> Claim.of("contour factor",
                c.get("id").asText(), () -> Figure.relative("relative or 1e-9", 1e-6, 1e-9, exact(c), contour(c))));
    }

    /** Of the ray caster: with one ray as for prediction, and with four as in the paper's schedule. */
    public static Stream<Claim> rayCaster() {
        return SharedData.cases(FILE).stream().flatMap(c -> IntStream.of(1, 4).mapToObj(rays -> Claim.of("ray caster, "
                + (rays == 1 ? "1 ray" : rays + " rays"), c.get("id").asText(),
                () -> Figure.relative("relative or 1e-4", 1e-2, 1e-4, exact(c), cast(c, rays)))));
    }

    private static double exact(JsonNode c) {
        return c.get("F12").asDouble();
    }

    @ParameterizedTest
    @MethodSource("contour")
    void contourFactor_isExact(Claim claim) {
        claim.check();
    }

    @ParameterizedTest
    @MethodSource("rayCaster")
    void rayCaster_isRightByDefault(Claim claim) {
        claim.check();
    }

    private static double contour(JsonNode c) {
        Vec3[] to = SharedData.polygon(c.get("polygon2"));
        if (c.has("point")) {
            return factor(SharedData.vector(c.get("point")), SharedData.vector(c.get("normal")), to);
        }
        Vec3[] from = SharedData.polygon(c.get("polygon1"));
        Vec3 normal = normal(from);
        return Quadrature.mean(from, to[0], normal(to), p -> factor(p, normal, to));
    }

    private static double cast(JsonNode c, int rays) {
        Calculated to = Calculated.of(c);
        FormFactorCalculator calculator = to.calculator(FormFactors.RAYCAST, rays);
        return c.has("point")
                ? to.from(calculator, SharedData.vector(c.get("point")), SharedData.vector(c.get("normal")), 7)
                : to.from(calculator, SharedData.polygon(c.get("polygon1")), POINTS);
    }

    static double factor(Vec3 point, Vec3 normal, Vec3[] polygon) {
        return ContourFactor.factor(point, normal.unit(), polygon);
    }

    public static Vec3 normal(Vec3[] polygon) {
        return polygon[1].minus(polygon[0]).cross(polygon[2].minus(polygon[0])).unit();
    }
}
