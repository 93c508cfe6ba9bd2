package radiosity.testkit;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/**
 * Closed rooms of one surface, seen from inside. All are watertight but the Cornell box, whose floor runs under its
 * blocks.
 */
public final class RoomScenes {

    private RoomScenes() { }

    /** A surface with the same values in all channels, in W/m² and as a part. */
    public static Surface grey(String name, double exitance, double reflectance) {
        return new Surface(name, Rgb.grey(exitance), Rgb.grey(reflectance), false);
    }

    /** Adds a box seen from inside. */
    public static void addRoom(SceneBuilder builder, Surface surface, Box room) {
        for (int side = 0; side < 6; side++) {
            builder.polygon(surface, room.inside(side));
        }
    }

    /** Adds a box seen from outside. */
    public static void addSolid(SceneBuilder builder, Surface surface, Vec3 low, Vec3 high) {
        Box box = new Box(low, high);
        for (int side = 0; side < 6; side++) {
            List<Vec3> outside = new ArrayList<>(List.of(box.inside(side)));
            Collections.reverse(outside);
            builder.polygon(surface, outside.toArray(Vec3[]::new));
        }
    }

    public static Scene cube(Surface all) {
        return box("cube", Box.UNIT, all);
    }

    public static Scene corridor(Surface all) {
        return box("corridor", new Box(Vec3.ZERO, new Vec3(1, 1, 50)), all);
    }

    private static Scene box(String name, Box box, Surface all) {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            builder.polygon(all, box.inside(side));
        }
        return builder.scene(name);
    }

    /** Two squares wide and deep without one of the four. */
    public static Scene lShaped(Surface all) {
        double[] two = {0, 2, 4};
        return new Cells(two, new double[] {0, 3}, two).room("L-shaped room", (i, j, k) -> i == 0 || k == 0, all);
    }

    /** Two blocks stand on the floor of a room of 5 x 3 x 4, which does not run under them. */
    public static Scene withBlocks(Surface all) {
        return withBlocks(all, all);
    }

    /** The same with a lamp in the middle of the ceiling. */
    public static Scene withBlocks(Surface wall, Surface lamp) {
        return new Cells(new double[] {0, 1, 2, 3, 4.2, 5}, new double[] {0, 0.8, 1.7, 3},
                new double[] {0, 0.7, 1.6, 2.3, 3.2, 4}).room("room with blocks", RoomScenes::besideBlocks,
                (i, j, k, side) -> side == 3 && j == 2 && i == 2 && k == 2 ? lamp : wall);
    }

    private static boolean besideBlocks(int i, int j, int k) {
        return !(i == 1 && k == 1 && j < 2 || i == 3 && k == 3 && j < 1);
    }

    /** A cube of a third of the room's size hangs in its middle. */
    public static Scene withFloatingCube(Surface all) {
        double[] three = {0, 1, 2, 3};
        return new Cells(three, three, three).room("room with a floating cube",
                (i, j, k) -> i != 1 || j != 1 || k != 1, all);
    }

    /** The Cornell box with its two blocks, in m, closed by a front wall. */
    public static Scene closedCornell(Surface all) {
        SceneBuilder builder = new SceneBuilder();
        Box room = new Box(Vec3.ZERO, new Vec3(0.556, 0.5488, 0.5592));
        for (int side = 0; side < 6; side++) {
            builder.polygon(all, room.inside(side));
        }
        CORNELL_BLOCKS.forEach(block -> block.addTo(builder, all));
        return builder.scene("closed Cornell box");
    }

    /** Cornell University Program of Computer Graphics, Cornell Box Data, 1998; mm there, m here. */
    public static final List<Prism> CORNELL_BLOCKS = List.of(
            new Prism(0.165, new double[] {.130, .065, .082, .225, .240, .272, .290, .114}),
            new Prism(0.330, new double[] {.423, .247, .265, .296, .314, .456, .472, .406}));

    /** Whether a point of the closed Cornell box is not under a block. */
    public static boolean isOpenInCornell(Vec3 p) {
        return CORNELL_BLOCKS.stream().noneMatch(block -> block.covers(p));
    }

    /** The watertight ones by name. */
    public static Map<String, Function<Surface, Scene>> watertight() {
        return new TreeMap<>(Map.of("cube", RoomScenes::cube, "corridor", RoomScenes::corridor, "L-shaped room",
                RoomScenes::lShaped,
                "room with blocks", RoomScenes::withBlocks, "room with a floating cube", RoomScenes::withFloatingCube));
    }
}
