package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.accuracy.Rooms;
import radiosity.accuracy.Solve;
import radiosity.accuracy.Spread;

/** Radiosity is in proportion to emission over sixty powers of ten. */
class EmissionTest {

    @ParameterizedTest
    @ValueSource(doubles = {1e-30, 1e-9, 1, 1e9, 1e30})
    void furnace_isExactAtAnyEmission(double emission) {
        Spread found = Spread.radiosity(Solve.byDefault().solution(Rooms.lShaped(Rooms.grey("wall", emission, 0.5))), 0);
        assertEquals(2 * emission, found.low(), 1e-3 * emission);
        assertEquals(2 * emission, found.high(), 1e-3 * emission);
    }
}
