package radiosity.visibility;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.mesh.face.Faces;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;

/** A tube that ends at a plate: what of the plate lies in the tube is inside, whatever lies behind the far end. */
class SolidsTest {

    private static Vec3[] square(double low, double high, double z) {
        return new Vec3[] {new Vec3(low, low, z), new Vec3(high, low, z), new Vec3(high, high, z),
                new Vec3(low, high, z)};
    }

    /** @param isFirst whether the plate at the far end comes before the tube in the scene */
    private static Scene scene(boolean isFirst, boolean isTwoSided) {
        Surface plate = new Surface("plate", Rgb.BLACK, Rgb.grey(.5), isTwoSided);
        SceneBuilder builder = new SceneBuilder();
        if (isFirst) {
            builder.polygon(plate, square(0, 1, .1));
        }
        Box tube = new Box(new Vec3(.3, .3, 0), new Vec3(.7, .7, .1));
        for (int side = 0; side < 6; side++) {
            Vec3[] inside = tube.inside(side);
            builder.polygon(RoomScenes.grey("tube", 1, 0), inside[3], inside[2], inside[1], inside[0]);
        }
        if (!isFirst) {
            builder.polygon(plate, square(0, 1, .1));
        }
        return builder.scene("tube");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void pointInTube_isInside_whereThePlateAtItsEndIsSeenFromTheFront(int kind) {
        Faces faces = new Faces(scene((kind & 1) == 0, (kind & 2) == 0));
        Solids solids = new Solids(new RadiosityBounds(faces.occluders()), faces.fronts());
        Vec3 up = new Vec3(0, 0, 1);
        for (double x = .35; x < .66; x += .03) {
            assertTrue(solids.hold(faces.unit(new Vec3(x, .45, 0)), up), "at " + x);
        }
        assertFalse(solids.hold(faces.unit(new Vec3(.2, .45, 0)), up));
    }

    /** Walls that are modelled from both sides, as some programs write them: their backs are where their fronts are. */
    @Test
    void pointInRoomOfDoubleWalls_isNotInside() {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            Vec3[] inside = Box.UNIT.inside(side);
            builder.polygon(RoomScenes.grey("wall", 1, 0), inside);
            builder.polygon(RoomScenes.grey("wall", 1, 0), inside[3], inside[2], inside[1], inside[0]);
        }
        Faces faces = new Faces(builder.scene("room of double walls"));
        Solids solids = new Solids(new RadiosityBounds(faces.occluders()), faces.fronts());
        for (double x = .05; x < 1; x += .1) {
            assertFalse(solids.hold(faces.unit(new Vec3(x, .4, 0)), new Vec3(0, 0, 1)), "at " + x);
        }
    }

    /** A panel close below a ceiling, whose back is not modelled: where it is all that the ceiling sees but a slit. */
    @ParameterizedTest
    @ValueSource(doubles = {.001, .01, .03})
    void pointBehindTheBackOfASheet_isNotInside(double gap) {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            builder.polygon(RoomScenes.grey("wall", 0, .5), Box.UNIT.inside(side));
        }
        Vec3[] panel = square(.3, .7, 1 - gap);
        builder.polygon(RoomScenes.grey("lamp", 1, 0), panel[3], panel[2], panel[1], panel[0]);
        Faces faces = new Faces(builder.scene("room with a panel"));
        Solids solids = new Solids(new RadiosityBounds(faces.occluders()), faces.fronts());
        for (double x = .31; x < .7; x += .03) {
            assertFalse(solids.hold(faces.unit(new Vec3(x, .45, 1)), new Vec3(0, 0, -1)), "at " + x);
        }
    }
}
