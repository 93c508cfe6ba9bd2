package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.accuracy.CieCase.Measured;
import radiosity.output.points.Points;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Solution;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.Solve;

/**
 * CIE 171:2006 with the exact references of {@link Cie}; errors in per cent of a case's largest value.
 *
 * <p>5.8: with Phi emitted in a closed room of uniform reflectance, mean E = Phi/S + rho mean E, so the indirect part
 * is rho Phi / (S (1 - rho)): received flux / area, without what is received where nothing reflects.
 */
@Tag("slow")
public class CieTest {

    private static final double FLUX = 10_000;
    private static final double AREA = 96;

    static List<CieCase> cases() {
        return Cie.cases();
    }

    @ParameterizedTest
    @MethodSource("cases")
    void everyPoint_isWithinTwoPerCentOfTheLargest(CieCase test) {
        check(test, Solve.byDefault(), 0.02);
    }

    /** For ten minutes on two cores. */
    @Tag("thorough")
    @ParameterizedTest
    @MethodSource("cases")
    void everyPoint_isWithinAFifthOfAPerCentWhereThatIsAsked(CieCase test) {
        check(test, Solve.byDefault().settings(RadiositySettings.defaults().accurate(0.002)), 0.002);
    }

    private static void check(CieCase test, Solve solve, double within) {
        Points found = new Points(solve.solution(test.scene()));
        for (Measured p : test.points()) {
            assertEquals(p.irradiance(), found.at(p.position(), p.normal()).irradiance().r(), within * test.largest(),
                    p.name());
        }
    }

    /** Of 5.8. */
    public static Stream<Claim> claims() {
        double direct = mean(0);
        return DoubleStream.of(.05, .1, .2, .3, .4, .5, .6, .7, .8, .9, .95, .99, .999, .9999)
                .mapToObj(rho -> Claim.of("CIE 171 case 5.8", "reflectance " + rho, () -> Figure.relative(
                        "mean indirect irradiance", 1e-4, rho * FLUX / (AREA * (1 - rho)), mean(rho) - direct)));
    }

    @ParameterizedTest
    @MethodSource("claims")
    void meanIndirectIrradiance_isExact(Claim claim) {
        claim.check();
    }

    private static double mean(double reflectance) {
        Scene cube = Cie.cube(reflectance);
        Solution solution = Solve.byDefault().unsent(1e-6).solution(cube);
        return solution.ledger().received()[0] / AREA;
    }
}
