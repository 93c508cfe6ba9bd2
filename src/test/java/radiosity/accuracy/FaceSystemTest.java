package radiosity.accuracy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.scene.Vec3;
import radiosity.settings.FormFactors;
import radiosity.testkit.Calculated;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.NeedsReference;
import radiosity.testkit.Quadrature;
import radiosity.testkit.SharedData;

/**
 * A box whose faces are not subdivided (equation 2 of the paper): B_i = E_i + rho_i sum over j of F_ij B_j, with the
 * form factors of the program's calculator, against the six unknowns that others computed ({@code
 * truth/enclosures.json}).
 *
 * <p>From a convex box's face all of another is visible and the factor is smooth but for the common edge, so it is
 * integrated by {@link Quadrature}.
 */
@Tag("slow")
@NeedsReference("truth/enclosures.json")
public class FaceSystemTest {

    private static final double ASKED = 3e-3;
    /** The largest reflectance is .9: 300 steps leave 1e-14 of what is emitted. */
    private static final int STEPS = 300;

    public static Stream<Claim> claims() {
        return EnclosuresTest.cases("box").map(c -> new Claim("enclosures: constant per face", c.get("id").asText(),
                () -> figures(c)));
    }

    @ParameterizedTest
    @MethodSource("claims")
    void unsubdividedBox_isThatOfTheExactSystem(Claim claim) {
        claim.check();
    }

    private static List<Figure> figures(JsonNode c) {
        List<Vec3[]> faces = new ArrayList<>();
        c.get("surfaces").forEach(s -> faces.add(SharedData.polygon(s.get("vertices"))));
        double[][] factors = factors(faces);
        List<Figure> figures = new ArrayList<>();
        for (int channel = 0; channel < 3; channel++) {
            double[] found = solve(factors, values(c, "emission", channel), values(c, "reflectance", channel));
            figures.add(figure(c.get("constant_radiosity").get("B"), channel, faces, found));
        }
        return figures;
    }

    private static double[] values(JsonNode c, String what, int channel) {
        double[] values = new double[c.get("surfaces").size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = c.get("surfaces").get(i).get(what).get(channel).asDouble();
        }
        return values;
    }

    private static double[][] factors(List<Vec3[]> faces) {
        double[][] factors = new double[faces.size()][faces.size()];
        for (int j = 0; j < faces.size(); j++) {
            Vec3[] shooting = faces.get(j);
            Calculated to = new Calculated(shooting, faces.stream().filter(face -> face != shooting).toList());
            for (int i = 0; i < faces.size(); i++) {
                if (i != j) {
                    Vec3[] from = faces.get(i);
                    Vec3 normal = FormFactorsTest.normal(from);
                    factors[i][j] = Quadrature.mean(from, shooting[0], FormFactorsTest.normal(shooting),
                            p -> to.from(to.calculator(FormFactors.RAYCAST, 1), p, normal, 7));
                }
            }
        }
        return factors;
    }

    private static double[] solve(double[][] factors, double[] exitance, double[] reflectance) {
        double[] b = exitance.clone();
        for (int step = 0; step < STEPS; step++) {
            for (int i = 0; i < b.length; i++) {
                double h = 0;
                for (int j = 0; j < b.length; j++) {
                    h += factors[i][j] * b[j];
                }
                b[i] = exitance[i] + reflectance[i] * h;
            }
        }
        return b;
    }

    /** The largest error of a face, of the mean over all. */
    private static Figure figure(JsonNode exact, int channel, List<Vec3[]> faces, double[] found) {
        double worst = 0;
        double flux = 0;
        double area = 0;
        for (int i = 0; i < found.length; i++) {
            double a = Quadrature.area(List.of(faces.get(i)));
            worst = Math.max(worst, Math.abs(found[i] - exact.get(i).get(channel).asDouble()));
            flux += a * exact.get(i).get(channel).asDouble();
            area += a;
        }
        return new Figure("worst face, of the mean", ASKED, worst * area / flux);
    }
}
