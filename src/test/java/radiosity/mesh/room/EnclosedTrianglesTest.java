package radiosity.mesh.room;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import radiosity.mesh.face.Faces;
import radiosity.scene.Camera;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;

/** A box in a closed cupboard is enclosed, unless light or the viewer may be inside, or the box reaches out. */
class EnclosedTrianglesTest {

    private static final Surface WOOD = RoomScenes.grey("wood", 0, .5);
    private static final Surface LAMP = RoomScenes.grey("lamp", 1, .5);
    private static final Box ROOM = new Box(new Vec3(-1, -1, -1), new Vec3(2, 2, 2));
    private static final Vec3 MIDDLE = new Vec3(.5, .5, .5);

    /** A room with a cupboard, below which a lamp hangs, and a box of 12 triangles in the cupboard. */
    private static SceneBuilder room(Vec3 low, Vec3 high) {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            builder.polygon(RoomScenes.grey("wall", 0, .5), ROOM.inside(side));
        }
        RoomScenes.addSolid(builder, LAMP, new Vec3(.2, .2, -.1), new Vec3(.8, .8, 0));
        RoomScenes.addSolid(builder, WOOD, Vec3.ZERO, new Vec3(1, 1, 1));
        RoomScenes.addSolid(builder, RoomScenes.grey("content", 0, .5), low, high);
        return builder;
    }

    private static SceneBuilder filled() {
        return room(new Vec3(.3, .3, .2), new Vec3(.7, .7, .4));
    }

    private static int enclosed(SceneBuilder builder) {
        return EnclosedTriangles.of(new Faces(builder.scene("cupboard"))).cardinality();
    }

    @Test
    void contentOfACupboard_isEnclosed() {
        assertEquals(12, enclosed(filled()));
    }

    /** Every triangle of the content is a point among the triangles that stop rays, and no other triangle is. */
    @Test
    void contentOfACupboard_stopsNoRays() {
        Faces faces = new InitialMesh(filled().scene("cupboard"), RadiositySettings.defaults()).faces;
        float[] corners = faces.occluders();
        int points = 0;
        for (int t = 0; t < faces.scene().triangles(); t++) {
            boolean isPoint = true;
            for (int i = 0; i < 3; i++) {
                isPoint &= corners[9 * t + i] == corners[9 * t + 3 + i] && corners[9 * t + i] == corners[9 * t + 6 + i];
            }
            assertEquals(faces.scene().surface(t).name().equals("content"), isPoint, "triangle " + t);
            points += isPoint ? 1 : 0;
        }
        assertTrue(points >= 12, points + " triangles");
    }

    @Test
    void contentOnTheBottomOfACupboard_isEnclosed_butForWhatShowsBelow() {
        assertEquals(10, enclosed(room(new Vec3(.3, .3, 0), new Vec3(.7, .7, .4))));
    }

    @Test
    void contentThatReachesOut_isFree() {
        assertEquals(0, enclosed(room(new Vec3(.3, .3, .2), new Vec3(.7, .7, 1.1))));
    }

    @Test
    void contentOfAnOpenCupboard_isFree() {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 5; side++) {
            Vec3[] inside = Box.UNIT.inside(side);
            builder.polygon(WOOD, inside[3], inside[2], inside[1], inside[0]);
        }
        RoomScenes.addSolid(builder, WOOD, new Vec3(.3, .3, .2), new Vec3(.7, .7, .4));
        assertEquals(0, enclosed(builder));
    }

    @Test
    void contentBesideALampOrTheCamera_isFree() {
        Light bulb = new Light("bulb", Light.Kind.POINT, Rgb.grey(1), MIDDLE, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, 1, 0, 0);
        assertEquals(0, enclosed(filled().light(bulb)));
        assertEquals(0, enclosed(filled().camera(new Camera(MIDDLE, new Vec3(0, 0, 1), new Vec3(0, 1, 0), .5, 1))));
        SceneBuilder lit = filled();
        RoomScenes.addSolid(lit, LAMP, new Vec3(.3, .3, .7), new Vec3(.7, .7, .8));
        assertEquals(0, enclosed(lit));
    }

    /** A house: an outer box that is seen from outside, and a room in it with a lamp. */
    @Test
    void roomInAHouse_isFree() {
        SceneBuilder builder = filled();
        RoomScenes.addSolid(builder, WOOD, new Vec3(-2, -2, -2), new Vec3(3, 3, 3));
        assertEquals(12, enclosed(builder));
    }

    @Test
    void contentOfABodyOfTwoSidedTriangles_isEnclosed() {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            builder.polygon(new Surface("sheet", Rgb.BLACK, Rgb.grey(.5), true), Box.UNIT.inside(side));
        }
        RoomScenes.addSolid(builder, WOOD, new Vec3(.3, .3, .2), new Vec3(.7, .7, .4));
        Faces all = new Faces(builder.scene("body"));
        Faces fronts = all.without(DarkCavities.of(all));
        assertEquals(12, EnclosedTriangles.of(fronts).cardinality());
        assertTrue(IntStream.range(0, 12).noneMatch(EnclosedTriangles.of(fronts)::get), "the body itself");
    }
}
