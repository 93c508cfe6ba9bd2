package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.accuracy.Polyhedra;
import radiosity.accuracy.Rooms;
import radiosity.accuracy.Solve;
import radiosity.accuracy.Spread;
import radiosity.scene.Scene;

/**
 * Furnaces up to reflectance .9999: B = E / (1 - rho) everywhere. What the form factors of a closed room lose or find
 * twice, d, is in B as d / (1 - rho): a part in 10,000 of deficit is nothing at rho = .5 and all of it at .9999.
 */
class WhiteFurnaceTest {

    private static Spread relative(Scene room, double reflectance) {
        Spread found = Spread.radiosity(Solve.byDefault().unsent(2e-5).solution(room), 0);
        double exact = 1 / (1 - reflectance);
        return new Spread(found.mean() / exact, found.low() / exact, found.high() / exact);
    }

    private static void isExact(Spread found) {
        assertEquals(1, found.mean(), 1e-4, "mean");
        assertEquals(1, found.low(), 5e-3, "lowest point");
        assertEquals(1, found.high(), 5e-3, "highest point");
    }

    @ParameterizedTest
    @MethodSource("roomsAndReflectances")
    void room_isExact(String name, double reflectance) {
        isExact(relative(Rooms.watertight().get(name).apply(Rooms.grey("wall", 1, reflectance)), reflectance));
    }

    static Stream<Arguments> roomsAndReflectances() {
        return Rooms.watertight().keySet().stream().flatMap(name -> DoubleStream.of(.5, .9, .99, .999, .9999)
                .mapToObj(reflectance -> Arguments.of(name, reflectance)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {.5, .9, .99, .999, .9999})
    void randomPolyhedra_areExact(double reflectance) {
        for (long seed = 0; seed < 50; seed++) {
            isExact(relative(Polyhedra.random(seed, Rooms.grey("wall", 1, reflectance)), reflectance));
        }
    }
}
