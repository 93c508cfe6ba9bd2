package radiosity.extremes;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.Cells;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.Moves;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.testkit.Spread;

/**
 * Two closed rooms in one scene do not know of each other: each is as it is alone, however much brighter the other is.
 */
@Tag("slow")
public class DynamicRangeTest {

    private static final double ASKED = 1e-3;
    private static final Vec3 BESIDE = new Vec3(10, 0, 0);
    private static final int PATCHES = 300;
    private static final double ACCURACY = 0.01;

    public static Stream<Claim> claims() {
        return DoubleStream.of(1e9).mapToObj(bright -> new Claim("two rooms, one brighter", "by 1e9",
                () -> figures(bright)));
    }

    private static List<Figure> figures(double bright) {
        Scene first = room(bright, Vec3.ZERO);
        Scene second = room(1, BESIDE);
        Solve solve = Solve.byDefault().accurate(ACCURACY).unsent(1e-4).patches(first, PATCHES);
        Solution both = solve.solution(together(first, second));
        return List.of(figure("bright room", solve.solution(first), both, true),
                figure("dim room", solve.solution(second), both, false));
    }

    private static Figure figure(String what, Solution alone, Solution both, boolean bright) {
        return Figure.relative(what + ": mean", ASKED, Spread.radiosity(alone, 0).mean(), Spread.of(both,
                p -> p.x() < 7 == bright, (e, k) -> both.radiosityAt(e, k).r()).mean());
    }

    /** A lamp in a corner of the ceiling, and a block that hangs in the middle. */
    private static Scene room(double exitance, Vec3 at) {
        Surface wall = RoomScenes.grey("wall " + at, 0, 0.5);
        Surface lamp = RoomScenes.grey("lamp " + at, exitance, 0.5);
        double[] planes = {0, 1, 2, 4};
        return Moves.moved(new Cells(planes, new double[] {0, 1, 2, 3}, planes).room("room",
                (i, j, k) -> i != 1 || j != 1 || k != 1,
                (i, j, k, side) -> side == 3 && i == 0 && k == 0 ? lamp : wall), at);
    }

    private static Scene together(Scene a, Scene b) {
        double[] points = join(a.points(), b.points());
        int[] corners = new int[a.corners().length + b.corners().length];
        int[] surfaceOf = new int[a.triangles() + b.triangles()];
        for (int i = 0; i < corners.length; i++) {
            int other = i - a.corners().length;
            corners[i] = other < 0 ? a.corners()[i] : b.corners()[other] + a.points().length / 3;
        }
        for (int t = 0; t < surfaceOf.length; t++) {
            int other = t - a.triangles();
            surfaceOf[t] = other < 0 ? a.surfaceOf()[t] : b.surfaceOf()[other] + a.surfaces().size();
        }
        List<Surface> surfaces = new ArrayList<>(a.surfaces());
        surfaces.addAll(b.surfaces());
        return new Scene("two rooms", points, corners, surfaceOf, surfaces, List.of(), Optional.empty());
    }

    private static double[] join(double[] a, double[] b) {
        double[] all = Arrays.copyOf(a, a.length + b.length);
        System.arraycopy(b, 0, all, a.length, b.length);
        return all;
    }

    @ParameterizedTest
    @MethodSource("claims")
    void room_isAsItIsAlone(Claim claim) {
        claim.check();
    }
}
