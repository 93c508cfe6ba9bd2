package radiosity.extremes;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.testkit.Spread;

/** Radiosity is in proportion to emission over 78 powers of ten, as far as floats of a file go. */
@Tag("slow")
public class EmissionTest {

    public static Stream<Claim> claims() {
        return DoubleStream.of(1e-44, 1e-30, 1, 1e30, 1e34).mapToObj(emission -> new Claim("emission 1e-44 to 1e34",
                "emission " + emission, () -> figures(emission)));
    }

    private static List<Figure> figures(double emission) {
        Spread found = Spread.radiosity(Solve.byDefault()
                .solution(RoomScenes.lShaped(RoomScenes.grey("wall", emission, 0.5))), 0);
        return List.of(Figure.relative("every point", 1e-3, 2 * emission, found.low()),
                Figure.relative("every point", 1e-3, 2 * emission, found.high()));
    }

    @ParameterizedTest
    @MethodSource("claims")
    void furnace_isExactAtAnyEmission(Claim claim) {
        claim.check();
    }
}
