package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.testkit.Spread;

/**
 * Furnace: where every surface of a closed room emits E and reflects rho, B = E + rho B everywhere, whatever stands in
 * the room, so B = E / (1 - rho). The part of its sky that a point does not find again is missing from B, and what is
 * found twice is too much. Little light is left unshot: 1e-5 of what is emitted.
 */
@Tag("slow")
class FurnaceTest {

    private static final Surface WALL = RoomScenes.grey("wall", 1, 0.5);
    private static final double EXACT = 2;
    private static final Solve SOLVE = Solve.byDefault().unsent(1e-5);

    @ParameterizedTest
    @ValueSource(strings = {"cube", "L-shaped room", "room with blocks", "room with a floating cube", "corridor"})
    void furnace_isExactOnAverage(String name) {
        assertEquals(EXACT, spread(RoomScenes.watertight().get(name).apply(WALL), SOLVE, p -> true).mean(),
                1e-3 * EXACT);
    }

    @Test
    void furnace_isExactOnAverageInTheClosedCornellBox() {
        assertEquals(EXACT, spread(RoomScenes.closedCornell(WALL), SOLVE, RoomScenes::isOpenInCornell).mean(),
                1e-3 * EXACT);
    }

    @ParameterizedTest
    @ValueSource(strings = {"cube", "L-shaped room", "room with blocks", "room with a floating cube", "corridor"})
    void furnace_isUniformInEveryRoom(String name) {
        isUniform(spread(RoomScenes.watertight().get(name).apply(WALL), SOLVE, p -> true));
    }

    @Test
    void furnace_isUniformInTheClosedCornellBox() {
        isUniform(spread(RoomScenes.closedCornell(WALL), SOLVE, RoomScenes::isOpenInCornell));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 48, 192, 768})
    void furnace_isExactForEveryMesh(int patches) {
        Scene cube = RoomScenes.cube(WALL);
        Spread found = spread(cube, SOLVE.patches(cube, patches), p -> true);
        assertEquals(EXACT, found.mean(), 1e-3 * EXACT);
        isUniform(found);
    }

    private static Spread spread(Scene room, Solve solve, Predicate<Vec3> open) {
        Solution solution = solve.solution(room);
        return Spread.of(solution, open, (e, k) -> solution.radiosityAt(e, k).r());
    }

    private static void isUniform(Spread found) {
        assertEquals(EXACT, found.low(), 1e-2 * EXACT, "lowest point");
        assertEquals(EXACT, found.high(), 1e-2 * EXACT, "highest point");
    }
}
