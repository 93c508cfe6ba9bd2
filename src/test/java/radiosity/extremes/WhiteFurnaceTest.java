package radiosity.extremes;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.scene.Scene;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.Polyhedra;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.testkit.Spread;

/**
 * Furnaces up to reflectance .9999: B = E / (1 - rho) everywhere. What the form factors of a closed room lose or find
 * twice, d, is in B as d / (1 - rho): a part in 10,000 of deficit is nothing at rho = .5 and all of it at .9999.
 */
@Tag("slow")
public class WhiteFurnaceTest {

    /** The command has five times as many. */
    private static final int POLYHEDRA = 10;

    static Stream<Claim> claims() {
        return claims(POLYHEDRA);
    }

    /** Rooms, then polyhedra. */
    public static Stream<Claim> claims(int polyhedra) {
        return DoubleStream.of(.5, .9, .99, .999, .9999).boxed()
                .flatMap(rho -> Stream.concat(rooms(rho), polyhedra(rho, polyhedra)));
    }

    private static Stream<Claim> rooms(double rho) {
        return RoomScenes.watertight().keySet().stream().map(name -> claim("furnace: " + name, name + " " + rho, rho,
                () -> RoomScenes.watertight().get(name).apply(RoomScenes.grey("wall", 1, rho))));
    }

    private static Stream<Claim> polyhedra(double rho, int count) {
        return LongStream.range(0, count).mapToObj(seed -> claim("furnace: random polyhedra",
                "polyhedron " + seed + " " + rho, rho, () -> Polyhedra.random(seed, RoomScenes.grey("wall", 1, rho))));
    }

    private static Claim claim(String group, String name, double rho, Supplier<Scene> room) {
        return new Claim(group, name, () -> {
            Spread found = Spread.radiosity(Solve.byDefault().unsent(2e-5).solution(room.get()), 0);
            double exact = 1 / (1 - rho);
            return List.of(Figure.relative("mean", 1e-4, exact, found.mean()),
                    Figure.relative("every point", 5e-3, exact, found.low()),
                    Figure.relative("every point", 5e-3, exact, found.high()));
        });
    }

    @ParameterizedTest
    @MethodSource("claims")
    void closedRoom_isExact(Claim claim) {
        claim.check();
    }
}
