package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;
import radiosity.solution.Progress;
import radiosity.solution.Solution;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.util.NoNumberException;

/** What is no number does not leave the solver. */
class NumbersTest {

    private static final Solution CUBE = Solve.byDefault().solution(RoomScenes.cube(RoomScenes.grey("wall", 1, 0.5)));

    static Stream<Double> noNumbers() {
        return DoubleStream.of(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 2 * Solution.LARGEST)
                .boxed();
    }

    /** The cube's solution in which one vertex has another irradiance. */
    private static Solution with(double irradiance, double unshotFlux) {
        double[] h = CUBE.irradiance().clone();
        h[h.length / 2] = irradiance;
        return new Solution(CUBE.scene(), CUBE.channels(), CUBE.positions(), h, CUBE.corners(), CUBE.faceOf(),
                CUBE.shots(), CUBE.rounds(), unshotFlux, CUBE.ledger(), CUBE.state());
    }

    @Test
    void numbers_pass() {
        assertEquals(1, with(1, 0).irradiance()[CUBE.irradiance().length / 2]);
    }

    @ParameterizedTest
    @MethodSource("noNumbers")
    void irradianceThatIsNone_isCaught(double irradiance) {
        String message = assertThrows(NoNumberException.class, () -> with(irradiance, 0)).getMessage();
        assertTrue(message.startsWith("solution: expected an irradiance of at most"), message);
        assertTrue(message.contains("got " + irradiance + " at ("), message);
    }

    @Test
    void unshotFluxThatIsNone_isCaught() {
        assertThrows(NoNumberException.class, () -> with(1, Double.NaN));
    }

    @Test
    void ledgerThatIsNone_isCaught() {
        for (int i = 0; i < 6; i++) {
            double[][] flux = new double[6][1];
            flux[i][0] = Double.NaN;
            assertEquals("ledger: expected numbers, got NaN", assertThrows(NoNumberException.class,
                    () -> new EnergyLedger(flux[0], flux[1], flux[2], flux[3], flux[4], flux[5])).getMessage());
        }
    }

    @Test
    void certificateThatIsNone_isCaught() {
        for (int i = 0; i < 13; i++) {
            double[] x = new double[13];
            x[i] = Double.POSITIVE_INFINITY;
            assertEquals("certificate: expected numbers, got Infinity",
                    assertThrows(NoNumberException.class, () -> certificate(x)).getMessage());
        }
        assertNull(new Certificate(1, null, 1, 1, 0, 0, 0, 0, 0, 0, List.of()).missingFlux(), "no bound");
    }

    private static Certificate certificate(double[] x) {
        return new Certificate(1, x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8],
                List.of(new Certificate.SurfaceError("wall", 1, x[9], x[10], x[11], x[12])));
    }

    @Test
    void progressThatIsNone_isCaught() {
        assertThrows(NoNumberException.class, () -> new Progress(1, 1, Double.NaN, 1, false));
    }

    /** Not by luck: a light so strong that it overflows on its way is met at once. */
    @Test
    void overflowOnTheWay_isCaught() {
        assertThrows(NoNumberException.class,
                () -> Solve.byDefault().solution(RoomScenes.lShaped(RoomScenes.grey("wall", 1e300, 0.5))));
    }
}
