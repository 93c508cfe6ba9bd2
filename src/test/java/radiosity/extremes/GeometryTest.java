package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.Box;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.testkit.Spread;

/**
 * Broken and odd meshes: every radiosity is a number, none below what is emitted, the mean not above a closed room's.
 */
@Tag("slow")
public class GeometryTest {

    private static final double REFLECTANCE = 0.5;
    private static final Surface WALL = RoomScenes.grey("wall", 1, REFLECTANCE);
    private static final Vec3[] SQUARE = {
        new Vec3(0.3, 0.5, 0.3), new Vec3(0.3, 0.5, 0.7), new Vec3(0.7, 0.5, 0.7), new Vec3(0.7, 0.5, 0.3)};

    private static SceneBuilder cube() {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            builder.polygon(WALL, Box.UNIT.inside(side));
        }
        return builder;
    }

    /** Two boxes that stand in one another. */
    private static SceneBuilder crossing() {
        SceneBuilder builder = cube();
        for (Box box : List.of(new Box(new Vec3(0.2, 0.1, 0.2), new Vec3(0.6, 0.5, 0.6)),
                new Box(new Vec3(0.4, 0.3, 0.4), new Vec3(0.8, 0.7, 0.8)))) {
            for (int side = 0; side < 6; side++) {
                Vec3[] p = box.inside(side);
                builder.polygon(WALL, p[3], p[2], p[1], p[0]);
            }
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
        made.put("solids that cross", crossing());
        made.put("polygon that is not plane", cube().polygon(WALL, a, new Vec3(0.3, 0.7, 0.7), SQUARE[2],
                new Vec3(0.7, 0.4, 0.3)));
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

    public static Stream<Claim> claims() {
        return scenes().keySet().stream().map(name -> new Claim("broken and odd meshes", name, () -> figures(name)));
    }

    private static List<Figure> figures(String name) {
        Spread found = Spread.radiosity(Solve.byDefault().solution(scenes().get(name)), 0);
        return List.of(new Figure("lowest below what is emitted", 1e-2, Math.max(0, 1 - found.low())),
                new Figure("mean above a furnace's", 1e-3, Math.max(0, found.mean() * (1 - REFLECTANCE) - 1)),
                new Figure("points that are no number", 0, Double.isFinite(found.high()) ? 0 : 1));
    }

    @ParameterizedTest
    @MethodSource("claims")
    void brokenMesh_hasLightOfAFurnaceAtMost(Claim claim) {
        claim.check();
    }

    @Test
    void whatSeesNothing_hasWhatItEmits() {
        Solution solution = Solve.byDefault().solution(scenes().get("nothing sees anything"));
        for (int e = 0; e < solution.elements(); e++) {
            assertEquals(1, solution.radiosityAt(e, 0).r(), 1e-12);
        }
    }
}
