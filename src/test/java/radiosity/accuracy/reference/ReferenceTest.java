package radiosity.accuracy.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.testkit.Evaluate;
import radiosity.testkit.Solve;

/**
 * Two rooms at an asked accuracy against path-traced radiosities that are part of the repository, so that this proof
 * needs no data from elsewhere.
 *
 * <p>The error of a point is (radiosity - reference) / max(mean, reference / 3) of the mean of the colours, as
 * {@code --accuracy} means it; the points stand for equal areas. The references err independently of the program, so
 * the squares of both errors add up: the root mean square is at most sqrt(asked² + noise²), where noise is the root
 * mean square of the standard errors in the same unit. The mean error is at most half of what is asked.
 */
class ReferenceTest {

    /** Least x of the points of the second room, m. */
    private static final double BEHIND_DOORWAY = 3.2;

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"blocks,0.05", "blocks,0.02", "doorway,0.05", "doorway,0.02"})
    void error_isAtMostWhatWasAskedFor(String room, double asked) throws IOException {
        Errors errors = Errors.of(ReferenceFile.rows(room), found(Room.named(room), asked), row -> true);
        assertEquals(ReferenceFile.POINTS, errors.points());
        assertTrue(errors.noise() <= ReferenceFile.NOISE, errors.toString());
        assertTrue(errors.rms() <= Math.hypot(asked, errors.noise()), errors.toString());
        assertEquals(0, errors.bias(), asked / 2, errors.toString());
    }

    /** Relative to its own mean, which is about an eighth of that of the room with the lamp. */
    @Test
    void roomBehindTheDoorway_isWithinFivePerCentOfItsOwnMean() throws IOException {
        Errors errors = Errors.of(ReferenceFile.rows("doorway"), found(Room.twoRooms(), 0.02),
                row -> row.place()[0] >= BEHIND_DOORWAY);
        assertTrue(errors.points() >= ReferenceFile.POINTS / 4, errors.toString());
        assertTrue(errors.rms() <= Math.hypot(0.05, errors.noise()), errors.toString());
    }

    /** Where everything emits 1 and reflects rho, the radiosity is 1 / (1 - rho) everywhere: no data, no noise. */
    @ParameterizedTest
    @ValueSource(strings = {"blocks", "doorway"})
    void furnace_isTheClosedFormAtThePoints(String name) throws IOException {
        double rho = 0.6;
        Material all = new Material("all", new double[] {1, 1, 1}, new double[] {rho, rho, rho});
        for (double found : found(Room.named(name).with(m -> all), 0.02)) {
            assertEquals(1 / (1 - rho), found, 0.02 / (1 - rho));
        }
    }

    /** Radiosities at the points of a room: red, green, blue per point, W/m². */
    private static double[] found(Room room, double asked) throws IOException {
        double[] places = ReferenceFile.rows(room.name()).stream().map(ReferenceFile.Row::place)
                .flatMapToDouble(Arrays::stream).toArray();
        return Evaluate.radiosity(Solve.byDefault().accurate(asked).solution(room.scene()), places);
    }

    /**
     * How far the program is from the references.
     *
     * @param points number of points
     * @param rms    root mean square error, relative
     * @param bias   mean error, relative
     * @param noise  root mean square standard error of the references, relative
     */
    private record Errors(int points, double rms, double bias, double noise) {

        /** @param found red, green, blue for each of the rows, also for those that are not looked at; W/m² */
        static Errors of(List<ReferenceFile.Row> rows, double[] found, Predicate<ReferenceFile.Row> isLookedAt) {
            double mean = rows.stream().filter(isLookedAt).mapToDouble(row -> row.radiosity()[3]).average()
                    .orElseThrow();
            int points = 0;
            double squares = 0;
            double sum = 0;
            double noise = 0;
            for (int i = 0; i < rows.size(); i++) {
                ReferenceFile.Row row = rows.get(i);
                if (isLookedAt.test(row)) {
                    double unit = Math.max(mean, row.radiosity()[3] / 3);
                    double colours = (found[3 * i] + found[3 * i + 1] + found[3 * i + 2]) / 3;
                    double error = (colours - row.radiosity()[3]) / unit;
                    points++;
                    squares += error * error;
                    sum += error;
                    noise += row.error()[3] * row.error()[3] / (unit * unit);
                }
            }
            return new Errors(points, Math.sqrt(squares / points), sum / points, Math.sqrt(noise / points));
        }
    }
}
