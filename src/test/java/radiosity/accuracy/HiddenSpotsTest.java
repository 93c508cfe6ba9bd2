package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.output.points.Points;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * Small lamps just above a floor: all light of the room comes from spots that no corner of the first mesh touches.
 * Elements at whose corners nothing is seen of that are looked into before they are believed.
 */
@Tag("slow")
class HiddenSpotsTest {

    private static final Surface WALL = RoomScenes.grey("wall", 0, .6);
    private static final Surface LAMP = RoomScenes.grey("lamp", 200, 0);
    private static final double SIZE = .08;
    private static final double ABOVE = .04;

    private static SceneBuilder walls() {
        SceneBuilder builder = new SceneBuilder();
        RoomScenes.addRoom(builder, WALL, new Box(Vec3.ZERO, new Vec3(3, 3, 3)));
        return builder;
    }

    private static Scene room() {
        SceneBuilder builder = walls();
        for (int i = 0; i < 9; i++) {
            double x = .41 + i % 3;
            double z = .37 + i / 3;
            builder.polygon(LAMP, new Vec3(x, ABOVE, z), new Vec3(x + SIZE, ABOVE, z), new Vec3(x + SIZE, ABOVE, z + SIZE),
                    new Vec3(x, ABOVE, z + SIZE));
        }
        return builder.scene("hidden spots");
    }

    /** A plate of a few centimetres that a bright tube goes through: the middles of its triangles are in the tube. */
    private static Scene plate() {
        SceneBuilder builder = walls();
        Box tube = new Box(new Vec3(1.507, 1.507, 1), new Vec3(1.533, 1.533, 2));
        for (int side = 0; side < 6; side++) {
            Vec3[] inside = tube.inside(side);
            builder.polygon(LAMP, inside[3], inside[2], inside[1], inside[0]);
        }
        builder.polygon(WALL, new Vec3(1.5, 1.5, 1.5), new Vec3(1.54, 1.5, 1.5), new Vec3(1.54, 1.54, 1.5),
                new Vec3(1.5, 1.54, 1.5));
        return builder.scene("plate around a tube");
    }

    @Test
    void plateWithCoveredMiddle_isLitBesideIt() throws IOException {
        Scene scene = plate();
        Points points = new Points(Solve.byDefault().solution(scene));
        int last = scene.triangles() - 1;
        Vec3 normal = scene.corner(last, 1).minus(scene.corner(last, 0))
                .cross(scene.corner(last, 2).minus(scene.corner(last, 0))).unit();
        double irradiance = points.at(new Vec3(1.538, 1.52, 1.5), normal).irradiance().r();
        assertTrue(irradiance > 20, "irradiance of " + irradiance);
    }

    /** Two sheets bent to prisms go through each other; they are no solids, but the middles of faces are dark inside. */
    @Test
    void facesThatCrossEachOther_areLitWhereTheyAreOutside() throws IOException {
        Surface sheet = new Surface("sheet", Rgb.BLACK, Rgb.grey(.6), true);
        SceneBuilder builder = walls();
        builder.polygon(RoomScenes.grey("lamp", 10, 0), new Vec3(1, 2.9, 1), new Vec3(2, 2.9, 1), new Vec3(2, 2.9, 2),
                new Vec3(1, 2.9, 2));
        Box one = new Box(new Vec3(1.4, 1.4, 1.4), new Vec3(1.415, 1.415, 1.415));
        Box other = new Box(new Vec3(1.403, 1.403, 1.41), new Vec3(1.412, 1.412, 1.425));
        for (int side = 0; side < 6; side++) {
            builder.polygon(sheet, one.inside(side));
            builder.polygon(sheet, other.inside(side));
        }
        Points points = new Points(Solve.byDefault().accurate(.2).solution(builder.scene("crossing boxes")));
        double rim = points.at(new Vec3(1.4015, 1.406, 1.415), new Vec3(0, 0, 1)).irradiance().r();
        double wall = points.at(new Vec3(1.4, 1.8, 0), new Vec3(0, 0, 1)).irradiance().r();
        assertTrue(rim > wall / 5, "irradiance of " + rim + " beside the other box, " + wall + " on the wall");
    }

    @Test
    void spots_areFound() {
        double error = Solve.byDefault().accurate(.05).certified(room(), true).certificate().expected();
        assertTrue(error <= .05, "expected error of " + error);
    }
}
