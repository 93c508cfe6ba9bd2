package radiosity.formfactor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A cell of side 2 from (3, 5) to (5, 7). */
class CutCellTest {

    private static final double NEAR = 0.005;

    private static CutCell.Part seen(CutCell.Sight sight) {
        boolean[] seen = {sight.sees(3, 5), sight.sees(3, 7), sight.sees(5, 7), sight.sees(5, 5)};
        return new CutCell(3, 5, 2, seen, sight).seen();
    }

    private static double share(CutCell.Sight sight) {
        CutCell.Part part = seen(sight);
        assertNotNull(part);
        assertNull(part.beyond());
        return part.share();
    }

    /** Share by a million points of the rows up to {@code last}. */
    private static double sampled(CutCell.Sight sight, double last) {
        int seen = 0;
        for (int i = 0; i < 1_000_000; i++) {
            seen += sight.sees(3 + (i / 1000 + 0.5) / 1000 * (last - 3), 5 + (i % 1000 + 0.5) / 500) ? 1 : 0;
        }
        return seen / 1e6 * (last - 3) / 2;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.8, 1.5, 2.2, 2.9, 3.6, 4.3, 5, 5.7})
    void straightEdge_leavesAreaOnEitherSide(double angle) {
        CutCell.Sight sight = (row, column) ->
                (row - 4.1) * Math.cos(angle) + (column - 6.2) * Math.sin(angle) > 0;

        assertEquals(sampled(sight, 5), share(sight), NEAR);
        assertEquals(1 - sampled(sight, 5), share((row, column) -> !sight.sees(row, column)), NEAR);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 1.3, 1.9, 2.2, 2.7})
    void roundEdge_leavesAreaOnEitherSide(double radius) {
        CutCell.Sight sight = (row, column) -> Math.hypot(row - 3, column - 5) < radius;

        assertEquals(sampled(sight, 5), share(sight), NEAR);
        assertEquals(1 - sampled(sight, 5), share((row, column) -> !sight.sees(row, column)), NEAR);
    }

    @Test
    void cornerOfEdge_leavesAreaOnEitherSide() {
        assertEquals(0.8 * 1.5 / 4, share((row, column) -> row < 3.8 && column < 6.5), NEAR);
        assertEquals(1 - 0.8 * 1.5 / 4, share((row, column) -> row > 3.8 || column > 6.5), NEAR);
    }

    @Test
    void cornerBeyondSide_countsHereAndTellsWhere() {
        CutCell.Part part = seen(CutCellTest::isInTip);

        assertEquals(sampled(CutCellTest::isInTip, 5.2), part.share(), 2 * NEAR);
        assertTrue(part.beyond()[0] > 5 && isInTip(part.beyond()[0] - 0.05, part.beyond()[1]));
    }

    /** A triangle with its tip at row 5.2. */
    private static boolean isInTip(double row, double column) {
        return Math.abs(column - 5.5) < (5.2 - row) * 0.8;
    }

    @Test
    void severalParts_areNoCut() {
        assertNull(seen((row, column) -> row - column < -3.5 || row - column > -0.5));
        assertNull(seen((row, column) -> row < 3.4 || Math.abs(column - 6) < 0.2));
    }
}
