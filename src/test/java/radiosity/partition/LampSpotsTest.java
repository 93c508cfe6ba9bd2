package radiosity.partition;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.mesh.Block;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;
import radiosity.util.ParallelFor;
import radiosity.visibility.RadiosityBounds;

/** Light of lamps between the corners of elements, which the corners do not receive. */
class LampSpotsTest {

    private static final Surface WALL = RoomScenes.grey("wall", 0, 0.5);
    private static final Surface LAMP = RoomScenes.grey("lamp", 100, 0);
    private static final Weights WEIGHTS = Weights.of(new double[] {1});

    /** A wall of one triangle in the plane y = 0, and a lamp of this size at a height above, which shines down. */
    private static SceneBuilder lampAbove(double height, double size) {
        return new SceneBuilder().polygon(WALL, Vec3.ZERO, new Vec3(0, 0, 10), new Vec3(10, 0, 0))
                .polygon(LAMP, new Vec3(3, height, 3), new Vec3(3 + size, height, 3), new Vec3(3, height, 3 + size));
    }

    private static RadiosityNodes wall(SceneBuilder builder) {
        Faces faces = new Faces(builder.scene("a lamp above a wall"));
        return new RadiosityNodes(new Patcher(faces, faces.area(), (f, small) -> null),
                List.of(new Block(0, new int[] {0}, new long[] {NodePath.FACE})));
    }

    private static boolean isSpoilt(RadiosityNodes wall, double error) {
        LampSpots spots = new LampSpots(wall.faces(), new RadiosityBounds(wall.faces().occluders()));
        return spots.spoil(wall, wall.tops()[0], WEIGHTS, error);
    }

    @Test
    void lampCloseToTheMiddle_spoils() {
        RadiosityNodes wall = wall(lampAbove(0.3, 0.3));
        assertTrue(isSpoilt(wall, 1));
        assertFalse(isSpoilt(wall, 50), "the wall reflects half of what the lamp emits at most");
    }

    @Test
    void lampBehindABoard_doesNot() {
        double y = 0.2;
        assertFalse(isSpoilt(wall(lampAbove(0.3, 0.3).polygon(WALL, new Vec3(-1, y, -1), new Vec3(-1, y, 12),
                new Vec3(12, y, -1))), 1));
    }

    @Test
    void lampThatShinesTheOtherWay_doesNot() {
        assertFalse(isSpoilt(wall(new SceneBuilder()
                .polygon(WALL, Vec3.ZERO, new Vec3(0, 0, 10), new Vec3(10, 0, 0))
                .polygon(LAMP, new Vec3(3, 0.3, 3), new Vec3(3, 0.3, 3.3), new Vec3(3.3, 0.3, 3))), 1));
    }

    /** Its light is nearly linear between the corners, so only a wall whose corners are all hidden may err. */
    @Test
    void lampFarAway_spoilsWhereAllCornersAreHidden() {
        RadiosityNodes wall = wall(lampAbove(20, 8));
        assertTrue(isSpoilt(wall, 0.5));
        wall.light().irradiance()[wall.corner(wall.tops()[0], 0)] = 100;
        assertFalse(isSpoilt(wall, 0.5));
    }

    @Test
    void spot_isDividedFor() {
        RadiosityNodes wall = wall(lampAbove(0.3, 0.3));
        LampSpots spots = new LampSpots(wall.faces(), new RadiosityBounds(wall.faces().occluders()));
        new MeshRefinement(wall, WEIGHTS, 1.5, spots).splitAll(1, new ParallelFor(1));
        assertEquals(4, wall.elements());
    }

    @Test
    void nearestPoint_isFoundInsideOnEdgesAndAtCorners() {
        Vec3[] triangle = {Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0)};
        assertArrayEquals(new double[] {0.5, 0.25, 0.25}, nearest(0.25, 0.25, triangle), 1e-12);
        assertArrayEquals(new double[] {1, 0, 0}, nearest(-1, -1, triangle), 1e-12);
        assertArrayEquals(new double[] {0, 1, 0}, nearest(3, -1, triangle), 1e-12);
        assertArrayEquals(new double[] {0, 0, 1}, nearest(-1, 3, triangle), 1e-12);
        assertArrayEquals(new double[] {0.75, 0.25, 0}, nearest(0.25, -1, triangle), 1e-12);
        assertArrayEquals(new double[] {0.75, 0, 0.25}, nearest(-1, 0.25, triangle), 1e-12);
        assertArrayEquals(new double[] {0, 0.5, 0.5}, nearest(1, 1, triangle), 1e-12);
    }

    private static double[] nearest(double x, double y, Vec3[] triangle) {
        return LampSpots.nearest(new Vec3(x, y, 2), triangle);
    }
}
