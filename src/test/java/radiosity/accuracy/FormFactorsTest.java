package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.formfactor.ContourFactor;
import radiosity.scene.Vec3;

/**
 * The exact contour factor against 82 form factors that were computed to 14 digits by others ({@code
 * truth/formfactors.json}).
 *
 * <p>From a point it is compared as it is. From an area, F12 = 1/A1 times the integral over polygon 1 of the factor from
 * its points to polygon 2; points behind polygon 2 receive nothing and are left out, for they would put a kink into the
 * integrand.
 */
class FormFactorsTest {

    static Stream<String> points() {
        return ids("point-to-polygon", true);
    }

    static Stream<String> areas() {
        return ids("point-to-polygon", false);
    }

    private static Stream<String> ids(String kind, boolean wanted) {
        return Shared.cases("formfactors.json").stream().filter(c -> c.get("kind").asText().equals(kind) == wanted)
                .filter(c -> !c.has("blockers")).map(c -> c.get("id").asText());
    }

    @ParameterizedTest
    @MethodSource("points")
    void contourFactor_isExactAtPoints(String id) {
        JsonNode c = Shared.find("formfactors.json", id);
        double found = factor(Shared.vector(c.get("point")), Shared.vector(c.get("normal")),
                flat(Shared.polygon(c.get("polygon2"))));
        assertEquals(c.get("F12").asDouble(), found, 1e-9);
    }

    @ParameterizedTest
    @MethodSource("areas")
    void contourFactor_integratesToTheFormFactor(String id) {
        JsonNode c = Shared.find("formfactors.json", id);
        Vec3[] from = Shared.polygon(c.get("polygon1"));
        Vec3[] to = Shared.polygon(c.get("polygon2"));
        Vec3 normal = normal(from);
        double[] flat = flat(to);
        double found = Quadrature.mean(from, to[0], normal(to), p -> factor(p, normal, flat));
        double expected = c.get("F12").asDouble();
        assertEquals(expected, found, Math.max(1e-9, 1e-6 * expected));
    }

    static double factor(Vec3 point, Vec3 normal, double[] polygon) {
        Vec3 n = normal.unit();
        return ContourFactor.factor(point.x(), point.y(), point.z(), n.x(), n.y(), n.z(), polygon);
    }

    static Vec3 normal(Vec3[] polygon) {
        return polygon[1].minus(polygon[0]).cross(polygon[2].minus(polygon[0])).unit();
    }

    static double[] flat(Vec3[] polygon) {
        return Arrays.stream(polygon).flatMapToDouble(p -> Arrays.stream(new double[] {p.x(), p.y(), p.z()})).toArray();
    }
}
