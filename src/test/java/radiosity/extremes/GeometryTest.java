package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.accuracy.Box;
import radiosity.accuracy.Rooms;
import radiosity.accuracy.SceneBuilder;
import radiosity.accuracy.Solve;
import radiosity.accuracy.Spread;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.world.Solution;

/** Broken and odd meshes: every radiosity is a number, none below what is emitted, the mean not above a closed room's. */
class GeometryTest {

    private static final double REFLECTANCE = 0.5;
    private static final Surface WALL = Rooms.grey("wall", 1, REFLECTANCE);
    private static final Vec3[] SQUARE = {
        new Vec3(0.3, 0.5, 0.3), new Vec3(0.3, 0.5, 0.7), new Vec3(0.7, 0.5, 0.7), new Vec3(0.7, 0.5, 0.3)};

    private static SceneBuilder cube() {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            builder.polygon(WALL, Box.UNIT.inside(side));
        }
        return builder;
    }

    private static Vec3[] moved(double up, boolean turned) {
        Vec3[] moved = new Vec3[4];
        for (int i = 0; i < 4; i++) {
            moved[i] = SQUARE[turned ? 3 - i : i].plus(new Vec3(0, up, 0));
        }
        return moved;
    }

    static Map<String, Scene> scenes() {
        Vec3 a = SQUARE[0];
        Vec3 b = SQUARE[1];
        Vec3 c = SQUARE[2];
        Map<String, SceneBuilder> made = new TreeMap<>();
        made.put("sliver of 1:1e6", cube().polygon(WALL, a, b, new Vec3(0.3 + 4e-7, 0.5, 0.5)));
        made.put("triangle without area", cube().polygon(WALL, a, b, a));
        made.put("corners in a line", cube().polygon(WALL, a, b, new Vec3(0.3, 0.5, 0.5)));
        made.put("triangle twice", cube().polygon(WALL, a, b, c).polygon(WALL, a, b, c));
        made.put("opposite faces in one place", cube().polygon(WALL, SQUARE).polygon(WALL, moved(0, true)));
        made.put("faces 1e-9 apart", cube().polygon(WALL, SQUARE).polygon(WALL, moved(-1e-9, true)));
        made.put("triangle inside another", cube().polygon(WALL, SQUARE)
                .polygon(WALL, new Vec3(0.4, 0.5, 0.4), new Vec3(0.4, 0.5, 0.6), new Vec3(0.6, 0.5, 0.5)));
        made.put("surfaces that cross", cube().polygon(WALL, SQUARE).polygon(WALL,
                new Vec3(0.5, 0.3, 0.3), new Vec3(0.5, 0.7, 0.3), new Vec3(0.5, 0.7, 0.7), new Vec3(0.5, 0.3, 0.7)));
        made.put("corner on an edge", cube().polygon(WALL, SQUARE)
                .polygon(WALL, new Vec3(0.7, 0.5, 0.5), new Vec3(0.9, 0.5, 0.4), new Vec3(0.9, 0.5, 0.6)));
        made.put("one triangle", new SceneBuilder().polygon(WALL, a, b, c));
        made.put("nothing sees anything", new SceneBuilder().polygon(WALL, SQUARE).polygon(WALL, moved(-1, true)));
        made.put("seen from behind only", new SceneBuilder().polygon(WALL, SQUARE).polygon(WALL, moved(1, false)));
        Map<String, Scene> scenes = new TreeMap<>();
        made.forEach((name, builder) -> scenes.put(name, builder.scene(name)));
        return scenes;
    }

    static Iterable<String> names() {
        return scenes().keySet();
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyRadiosity_isAtLeastWhatIsEmitted_andTheirMeanBelowAFurnace(String name) {
        Spread found = Spread.radiosity(Solve.byDefault().solution(scenes().get(name)), 0);
        assertTrue(found.low() >= 0.99 && Double.isFinite(found.high()), found.toString());
        assertTrue(found.mean() <= 1.001 / (1 - REFLECTANCE), found.toString());
    }

    @Test
    void whatSeesNothing_hasWhatItEmits() {
        Solution solution = Solve.byDefault().solution(scenes().get("nothing sees anything"));
        for (int e = 0; e < solution.elements(); e++) {
            assertEquals(1, solution.radiosityAt(e, 0).r(), 1e-12);
        }
    }
}
