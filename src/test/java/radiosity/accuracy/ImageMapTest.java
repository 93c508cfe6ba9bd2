package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.scene.ImageMap.Wrap;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * A floor whose halves differ by a picture gives the light of a floor of two surfaces: means under elements are what
 * counts for light between surfaces (section 6.1 of the paper).
 */
class ImageMapTest {

    private static final double BRIGHT = 0.8;
    private static final double DARK = 0.1;
    private static final int PIXELS = 64;

    private static final Surface WALL = RoomScenes.grey("wall", 0, 0.5);
    private static final Surface LAMP = RoomScenes.grey("lamp", 1, 0.2);

    private static Raster halves(double left, double right) {
        float[] rgb = new float[3 * PIXELS * PIXELS];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) (i / 3 % PIXELS < PIXELS / 2 ? left : right);
        }
        return new Raster(PIXELS, PIXELS, rgb, Wrap.EDGE, Wrap.EDGE, Rgb.BLACK);
    }

    private static Vec3[] floor(double from, double to) {
        return new Vec3[] {new Vec3(from, 0, 0), new Vec3(from, 0, 1), new Vec3(to, 0, 1), new Vec3(to, 0, 0)};
    }

    private static SceneBuilder room() {
        SceneBuilder builder = new SceneBuilder();
        for (int side : new int[] {0, 1, 4, 5}) {
            builder.polygon(WALL, Box.UNIT.inside(side));
        }
        return builder.polygon(LAMP, Box.UNIT.inside(3));
    }

    /** The floor is one square with a picture. */
    private static Scene mapped(Surface.Maps maps) {
        Scene plain = room().polygon(RoomScenes.grey("floor", 0, 0.3), floor(0, 1)).scene("mapped");
        List<Surface> surfaces = new ArrayList<>(plain.surfaces());
        int last = surfaces.size() - 1;
        surfaces.set(last, surfaces.get(last).with(maps));
        float[] places = new float[6 * plain.triangles()];
        for (int i = 0; i < 3 * plain.triangles(); i++) {
            Vec3 p = plain.corner(i / 3, i % 3);
            places[2 * i] = (float) p.x();
            places[2 * i + 1] = (float) p.z();
        }
        return new Scene(plain.name(), plain.points(), plain.corners(), plain.surfaceOf(), surfaces, List.of(),
                Optional.empty(), places);
    }

    private static double onWall(Solution solution, int axis, double at) {
        double sum = 0;
        double area = 0;
        for (int e = 0; e < solution.elements(); e++) {
            Vec3[] p = new Vec3[3];
            double mean = 0;
            boolean there = true;
            for (int k = 0; k < 3; k++) {
                int v = solution.corners()[3 * e + k];
                double[] x = solution.positions();
                p[k] = new Vec3(x[3 * v], x[3 * v + 1], x[3 * v + 2]);
                there &= Math.abs(x[3 * v + axis] - at) < 1e-9;
                mean += solution.irradianceAt(v).g() / 3;
            }
            double a = p[1].minus(p[0]).cross(p[2].minus(p[0])).length();
            sum += there ? a * mean : 0;
            area += there ? a : 0;
        }
        return sum / area;
    }

    private static void assertSameLight(Solution expected, Solution got) {
        for (int axis = 0; axis < 2; axis++) {
            for (int at = 0; at < 2; at++) {
                double h = onWall(expected, axis, at);
                assertEquals(h, onWall(got, axis, at), 0.01 * h, "wall " + axis + " at " + at);
            }
        }
    }

    @Test
    void halvesOfAPicture_reflectAsTwoSurfaces() {
        Solution two = Solve.byDefault().solution(room().polygon(RoomScenes.grey("bright", 0, BRIGHT), floor(0, 0.5))
                .polygon(RoomScenes.grey("dark", 0, DARK), floor(0.5, 1)).scene("two"));
        Solution one = Solve.byDefault().solution(
                mapped(new Surface.Maps(Optional.empty(), Optional.of(halves(BRIGHT, DARK)))));
        assertSameLight(two, one);
        assertTrue(onWall(one, 0, 0) > 1.05 * onWall(one, 0, 1), "the wall beside the bright half is brighter");
    }

    @Test
    void halvesOfAPicture_emitAsTwoSurfaces() {
        Solution two = Solve.byDefault().solution(room().polygon(RoomScenes.grey("bright", 2, 0.3), floor(0, 0.5))
                .polygon(RoomScenes.grey("dark", 0, 0.3), floor(0.5, 1)).scene("two"));
        Solution one = Solve.byDefault().solution(
                mapped(new Surface.Maps(Optional.of(halves(2, 0)), Optional.empty())));
        assertSameLight(two, one);
        assertEquals(two.ledger().emitted()[0], one.ledger().emitted()[0], 1e-6 * two.ledger().emitted()[0]);
        assertEquals(0, one.ledger().imbalance(0), 1e-6);
    }
}
