package radiosity.formfactor;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.mesh.CoincidentFaces;
import radiosity.mesh.InteriorTest;
import radiosity.mesh.PatchTree;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;

/** Light that leaves the floor of a cube without a ceiling: the form factor of opposite sides is 0.19982. */
class EscapingLightTest {

    private static final double FACTOR = 0.19982;

    private static Faces openCube() {
        SceneBuilder builder = new SceneBuilder();
        for (int side : new int[] {0, 1, 2, 4, 5}) {
            builder.polygon(RoomScenes.grey("wall", 1, .5), Box.UNIT.inside(side));
        }
        return new Faces(builder.scene("open cube"));
    }

    /** The two triangles of the floor, the second of them in four elements. */
    private static List<PatchTree> floor(double radiosity) {
        double[] one = new double[3];
        double[] four = new double[15];
        Arrays.fill(one, radiosity);
        Arrays.fill(four, 3, 15, radiosity);
        return List.of(new PatchTree(4, NodePath.FACE, new int[] {-1}, one),
                new PatchTree(5, NodePath.FACE, new int[] {1, -1, -1, -1, -1}, four));
    }

    static EscapingLight of(Faces faces) {
        RadiosityBounds bounds = new RadiosityBounds(faces.occluders());
        Solids solids = new Solids(bounds, faces.fronts());
        return new EscapingLight(faces, bounds, solids,
                new InteriorTest(faces, solids, new CoincidentFaces(faces, bounds), f -> false));
    }

    @Test
    void flux_isThatThroughTheOpening() {
        Faces faces = openCube();
        assertEquals(1, faces.channels());
        EscapingLight light = of(faces);
        double[] found = light.flux(floor(3), 1e-5);
        double error = Math.sqrt(found[1]);
        assertTrue(error > 0 && error < .01, "standard error of " + error);
        assertEquals(3 * FACTOR, found[0], 4 * error);
        assertArrayEquals(new double[] {-found[0], found[1]}, light.flux(floor(-3), 1e-5), 1e-12, "light taken back");
    }

    /** A blind, a lampshade: two faces in one place with their fronts outside, whose corners a file has rounded. */
    @Test
    void escapes_notWhereASheetsFrontLiesBehindItsBackByRounding() {
        Vec3[] below = {new Vec3(-1, -1, .5), new Vec3(-1, 1, .5), new Vec3(1, 1, .5), new Vec3(1, -1, .5 - 2e-6)};
        Vec3[] above = {below[1], below[0], below[3], below[2]};
        SceneBuilder builder = new SceneBuilder();
        builder.polygon(RoomScenes.grey("floor", 0, .5), new Vec3(0, 0, 0), new Vec3(.1, 0, 0), new Vec3(0, .1, 0));
        builder.polygon(RoomScenes.grey("sheet", 0, .5), below);
        builder.polygon(RoomScenes.grey("sheet", 0, .5), above);
        Faces faces = new Faces(builder.scene("a sheet over a floor"));
        EscapingLight light = of(faces);
        float[] middle = {0, 0, 0};
        for (int k = 0; k < 3; k++) {
            for (int a = 0; a < 3; a++) {
                middle[a] += faces.corner(0, k, a) / 3;
            }
        }
        for (int i = 0; i < 100; i++) {
            double p = .05 * (i / 10 - 4.5) / 4.5;
            double q = .05 * (i % 10 - 4.5) / 4.5;
            assertFalse(light.escapes(middle, 0, p, q), "direction " + p + " " + q);
        }
    }

    /** A lamp that touches a cupboard from below, with a box in it whose sides see nothing but the cupboard's backs. */
    @Test
    void escapes_whereLightFallsOnWhatIsInsideASolid() {
        SceneBuilder builder = new SceneBuilder();
        builder.polygon(RoomScenes.grey("lamp", 1, .5), new Vec3(.4, .4, 0), new Vec3(.6, .4, 0), new Vec3(.6, .6, 0));
        RoomScenes.addSolid(builder, RoomScenes.grey("cupboard", 0, .5), Vec3.ZERO, new Vec3(1, 1, 1));
        RoomScenes.addSolid(builder, RoomScenes.grey("content", 0, .5), new Vec3(.3, .3, .4), new Vec3(.7, .7, .6));
        Faces faces = new Faces(builder.scene("a cupboard"));
        EscapingLight light = of(faces);
        for (int i = 0; i < 100; i++) {
            assertTrue(light.escapes(faces.middle(0), 0, .018 * (i / 10 - 4.5), .018 * (i % 10 - 4.5)), "ray " + i);
        }
    }
}
