package radiosity.mesh.cut;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import radiosity.mesh.face.Faces;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;

/** Where corners lie inside the edges of coplanar neighbours, the neighbours are divided there. */
class EdgeMatcherTest {

    private static final Surface WALL = surface("wall");
    private static final Surface OTHER = surface("other");
    /** Below: a rectangle of 4 x 1. Above it: one of 1 x 2, and with a gap for a window one of 1.5 x 2. */
    private static final double[] AROUND_A_WINDOW = {0, 0, 0, 4, 0, 0, 4, 1, 0, 0, 1, 0,
        1, 1, 0, 1, 3, 0, 0, 3, 0,
        2.5, 1, 0, 4, 3, 0, 2.5, 3, 0};
    private static final int[] RECTANGLES = {0, 1, 2, 0, 2, 3, 3, 4, 5, 3, 5, 6, 7, 2, 8, 7, 8, 9};

    private static Surface surface(String name) {
        return new Surface(name, new Rgb(0, 0, 0), new Rgb(.5, .5, .5), false);
    }

    private static Scene scene(double[] points, int[] surfaces, float... texture) {
        return new Scene("wall", points, RECTANGLES, surfaces, List.of(WALL, OTHER), List.of(), Optional.empty(),
                texture);
    }

    private static ScenePieces.Cut match(Scene scene) {
        return EdgeMatcher.match(new ScenePieces.Cut(scene, IntStream.range(0, scene.triangles()).toArray()));
    }

    @Test
    void triangle_isDividedAtTheCornersOnItsEdge() {
        ScenePieces.Cut cut = match(scene(AROUND_A_WINDOW, new int[6]));
        assertArrayEquals(new int[] {0, 1, 1, 1, 2, 3, 4, 5}, cut.origin());
        assertEquals(4 + 2 + 3, cut.scene().area(), 1e-12);
        for (int t = 0; t < 8; t++) {
            assertTrue(cut.scene().cross(t).z() > .01, "a triangle without area, or seen from the other side");
        }
    }

    @Test
    void neighbours_areOneRegionThen() {
        Faces faces = new Faces(match(scene(AROUND_A_WINDOW, new int[6])).scene(), false);
        assertEquals(1, Arrays.stream(faces.part).distinct().count());
        assertEquals(3, Arrays.stream(new Faces(scene(AROUND_A_WINDOW, new int[6]), false).part).distinct().count());
    }

    @Test
    void cornersOfOtherSurfacesAndPlanes_divideNothing() {
        Scene painted = scene(AROUND_A_WINDOW, new int[] {0, 0, 1, 1, 1, 1});
        assertSame(painted, match(painted).scene());
        double[] bent = AROUND_A_WINDOW.clone();
        for (int p : new int[] {5, 6, 8, 9}) {
            bent[3 * p + 2] = 1;
        }
        Scene folded = scene(bent, new int[6]);
        assertSame(folded, match(folded).scene());
    }

    @Test
    void cornersBesideAnotherPointOfTheEdge_divideNothing() {
        double[] narrow = AROUND_A_WINDOW.clone();
        narrow[3 * 4] = 0.03;
        narrow[3 * 5] = 0.03;
        assertArrayEquals(new int[] {0, 1, 1, 2, 3, 4, 5}, match(scene(narrow, new int[6])).origin());
    }

    @Test
    void trianglesWithTextureCoordinates_stayWhole() {
        Scene textured = scene(AROUND_A_WINDOW, new int[6], new float[36]);
        assertSame(textured, match(textured).scene());
    }

    @Test
    void triangleWithVeryManyTVertices_staysWhole() {
        assertEquals(2 + 2 * 100 + 100 - 1, match(strip(100)).scene().triangles());
        Scene strip = strip(300);
        assertSame(strip, match(strip).scene());
    }

    /** A rectangle of n x 1, and above it n squares. */
    private static Scene strip(int n) {
        double[] points = new double[3 * (4 + 2 * (n + 1))];
        int[] corners = new int[3 * (2 + 2 * n)];
        double[][] rectangle = {{0, 0}, {n, 0}, {n, 1}, {0, 1}};
        for (int p = 0; p < points.length / 3; p++) {
            points[3 * p] = p < 4 ? rectangle[p][0] : (p - 4) / 2;
            points[3 * p + 1] = p < 4 ? rectangle[p][1] : 1 + p % 2;
        }
        int[] two = {0, 1, 2, 0, 2, 3};
        System.arraycopy(two, 0, corners, 0, 6);
        for (int i = 0; i < n; i++) {
            int a = 4 + 2 * i;
            int[] square = {a, a + 2, a + 3, a, a + 3, a + 1};
            System.arraycopy(square, 0, corners, 6 + 6 * i, 6);
        }
        return new Scene("strip", points, corners, new int[corners.length / 3], List.of(WALL), List.of(),
                Optional.empty());
    }

    @Test
    void origins_areThoseOfTheSceneThatWasCutBefore() {
        Scene scene = scene(AROUND_A_WINDOW, new int[6]);
        ScenePieces.Cut cut = EdgeMatcher.match(new ScenePieces.Cut(scene, new int[] {7, 7, 8, 8, 9, 9}));
        assertArrayEquals(new int[] {7, 7, 7, 7, 8, 8, 9, 9}, cut.origin());
    }
}
