package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.accuracy.Moves;
import radiosity.accuracy.Rooms;
import radiosity.accuracy.Solve;
import radiosity.accuracy.Spread;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.world.Solution;

/** Two closed rooms in one scene do not know of each other: each is as it is alone, however much brighter the other is. */
class DynamicRangeTest {

    private static final double BRIGHT = 1e9;

    private static Scene room(String name, double exitance, Vec3 at) {
        Surface wall = Rooms.grey(name, exitance, 0.5);
        return Moves.moved(Rooms.lShaped(wall), at);
    }

    private static Scene together(Scene a, Scene b) {
        double[] points = join(a.points(), b.points());
        int[] corners = new int[a.corners().length + b.corners().length];
        int[] surfaceOf = new int[a.triangles() + b.triangles()];
        for (int i = 0; i < corners.length; i++) {
            int other = i - a.corners().length;
            corners[i] = other < 0 ? a.corners()[i] : b.corners()[other] + a.points().length / 3;
        }
        for (int t = a.triangles(); t < surfaceOf.length; t++) {
            surfaceOf[t] = 1;
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

    @Test
    void brightRoom_isAsItIsAlone() {
        assertEquals(2 * BRIGHT, mean(true), 2e-3 * BRIGHT);
    }

    @Test
    void dimRoomBesideABrightOne_isAsItIsAlone() {
        assertEquals(2, mean(false), 2e-3);
    }

    private static double mean(boolean bright) {
        Scene scene = together(room("bright", BRIGHT, Vec3.ZERO), room("dim", 1, new Vec3(10, 0, 0)));
        Solution solution = Solve.byDefault().unsent(1e-4).solution(scene);
        return Spread.of(solution, p -> p.x() < 7 == bright, (e, k) -> solution.radiosityAt(e, k).r()).mean();
    }
}
