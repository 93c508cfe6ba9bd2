package radiosity.mesh.cut;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;

/** A wall in the plane z = 0 from -1 to 1, and a board of edge 1 before it, in its middle, that faces the wall. */
class GapBandsTest {

    private static Faces gap(double width, double reflectance, boolean faces) {
        Surface surface = RoomScenes.grey("grey", 0, reflectance);
        SceneBuilder scene = new SceneBuilder().polygon(surface, new Vec3(-1, -1, 0), new Vec3(1, -1, 0),
                new Vec3(1, 1, 0), new Vec3(-1, 1, 0));
        Vec3[] board = {new Vec3(-.5, -.5, width), new Vec3(-.5, .5, width), new Vec3(.5, .5, width),
            new Vec3(.5, -.5, width)};
        scene.polygon(surface, faces ? board : new Vec3[] {board[3], board[2], board[1], board[0]});
        return new Faces(scene.scene("gap"));
    }

    /** Distances of the lines on a face from the upper edge of the board, those along that edge, rising. */
    private static double[] depths(Faces faces, int face) {
        GapBands bands = new GapBands(faces, .01);
        return bands.on(face).stream().filter(line -> Math.abs(line.from().y() - line.to().y()) < 1e-9
                && line.from().y() > 0).mapToDouble(line -> .5 - line.from().y()).sorted().toArray();
    }

    @Test
    void linesLieOnBothSides_asDeepAsLightComes() {
        for (double[] expected : new double[][] {{.2, .02, .04}, {.5, .02, .04, .08}, {.8, .02, .04, .08, .16}}) {
            Faces faces = gap(.02, expected[0], true);
            double[] depths = IntStream.range(1, expected.length).mapToDouble(i -> expected[i]).toArray();
            for (int f = 0; f < faces.count(); f++) {
                assertArrayEquals(depths, depths(faces, f), 1e-6, "face " + f + " reflectance " + expected[0]);
            }
        }
    }

    @Test
    void wideGaps_andBacks_haveNone() {
        for (Faces faces : List.of(gap(.3, .8, true), gap(.02, .8, false))) {
            for (int f = 0; f < faces.count(); f++) {
                assertEquals(List.of(), new GapBands(faces, .01).on(f));
            }
        }
    }

    /** The same gap with its corners in another order, as another program writes them. */
    @Test
    void lines_doNotDependOnTheOrderOfCorners() {
        Scene scene = gap(.02, .8, true).scene();
        int[] turned = scene.corners().clone();
        for (int t = 0; t < turned.length; t += 3) {
            int first = turned[t];
            turned[t] = turned[t + 1];
            turned[t + 1] = turned[t + 2];
            turned[t + 2] = first;
        }
        Faces other = new Faces(new Scene("turned", scene.points(), turned, scene.surfaceOf(), scene.surfaces(),
                scene.lights(), scene.camera()));
        for (int f = 0; f < other.count(); f++) {
            assertArrayEquals(depths(gap(.02, .8, true), f), depths(other, f), 1e-12);
        }
    }
}
