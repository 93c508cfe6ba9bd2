package radiosity.mesh.cut;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.util.PointNumbers;

class QuadSplitterTest {

    private static final Surface GREY = new Surface("grey", new Rgb(0, 0, 0), new Rgb(.5, .5, .5), false);
    private static final double EVERYTHING = 1e-3;

    /** A rectangle from the origin in two triangles, another beside it along its long side. */
    private static Scene rectangles(double length, double width, float... texture) {
        double[] points = {0, 0, 0, length, 0, 0, length, width, 0, 0, width, 0, 0, 2 * width, 0, length, 2 * width, 0};
        int[] corners = {0, 1, 2, 0, 2, 3, 3, 2, 5, 3, 5, 4};
        return new Scene("rectangles", points, corners, new int[4], List.of(GREY), List.of(), Optional.empty(),
                texture);
    }

    @Test
    void longRectangle_isCutIntoSquares() {
        Scene cut = QuadSplitter.cut(rectangles(12, 1), EVERYTHING).scene();
        assertEquals(2 * 2 * 12, cut.triangles());
        for (int t = 0; t < cut.triangles(); t++) {
            assertEquals(0.5, cut.area(t), 1e-12);
            assertTrue(normalZ(cut, t) > 0, "a triangle is seen from the other side");
        }
    }

    @Test
    void pieces_comeFromTheTriangleThatTheyWere() {
        assertArrayEquals(new int[] {0, 1, 2, 3}, QuadSplitter.cut(rectangles(1.9, 1), EVERYTHING).origin());
        ScenePieces.Cut cut = QuadSplitter.cut(rectangles(12, 1), EVERYTHING);
        for (int i = 0; i < 48; i++) {
            int rectangle = i < 24 ? 0 : 1;
            Vec3 middle = cut.scene().corner(i, 0).plus(cut.scene().corner(i, 1)).plus(cut.scene().corner(i, 2))
                    .times(1.0 / 3);
            boolean isBelow = middle.y() - rectangle < middle.x() / 12;
            assertEquals(2 * rectangle + (isBelow ? 0 : 1), cut.origin()[i], "piece at " + middle);
        }
    }

    @Test
    void neighbours_haveTheSamePointsOnTheirCommonSide() {
        Scene cut = QuadSplitter.cut(rectangles(12, 1), EVERYTHING).scene();
        assertEquals(3 * 13, cut.points().length / 3);
        assertEquals(3 * 13, Arrays.stream(PointNumbers.of(cut.points())).distinct().count());
    }

    @Test
    void whatIsNotLong_isLeftAsItIs() {
        Scene square = rectangles(1.9, 1);
        assertSame(square, QuadSplitter.cut(square, EVERYTHING).scene());
    }

    @Test
    void whatIsNoLongerThanAPatch_isLeftAsItIs() {
        Scene small = rectangles(12, 1);
        assertSame(small, QuadSplitter.cut(small, 145).scene());
    }

    @Test
    void narrowRectangle_isCutIntoPiecesAsLongAsAPatch() {
        assertEquals(2 * 2 * 4, QuadSplitter.cut(rectangles(12, 0.1), 9).scene().triangles());
    }

    /** The side of a mitred frame: its diagonal is shorter than its longest side. */
    @Test
    void trapezium_isCutAlthoughItsDiagonalIsNotItsLongestEdge() {
        double[] points = {0, 0, 0, 12, 0, 0, 11.9, 0.1, 0, 0.1, 0.1, 0};
        Scene cut = QuadSplitter.cut(scene(points, 0, 1, 2, 0, 2, 3), 9).scene();
        assertEquals(2 * 4, cut.triangles());
    }

    /** Coordinates of files are single precision numbers: a narrow strip between them is not quite flat. */
    @Test
    void narrowStripOfRoundedCoordinates_isCut() {
        double tilt = 4e-7;
        double[] points = {-3, 0.1, -5.6, 3, 0.1, -5.6, 3, 0.09, -5.59, -3, 0.09 + tilt, -5.59};
        assertEquals(2 * 2, QuadSplitter.cut(scene(points, 0, 1, 2, 0, 2, 3), 10).scene().triangles());
        points[10] += 1e-3;
        assertEquals(2, QuadSplitter.cut(scene(points, 0, 1, 2, 0, 2, 3), 10).scene().triangles());
    }

    @Test
    void bentAndConcavePairs_areLeftAsTheyAre() {
        double[] concave = {0, 0, 0, 12, 0, 0, 6, 0.1, 0, 0, 1, 0};
        assertEquals(2, QuadSplitter.cut(scene(concave, 0, 1, 2, 0, 2, 3), 1).scene().triangles());
        double[] bent = {0, 0, 0, 12, 0, 0, 12, 1, 0, 0, 1, 1};
        assertEquals(2, QuadSplitter.cut(scene(bent, 0, 1, 2, 0, 2, 3), 1).scene().triangles());
    }

    private static Scene scene(double[] points, int... corners) {
        return new Scene("strip", points, corners, new int[corners.length / 3], List.of(GREY), List.of(),
                Optional.empty());
    }

    @Test
    void whatHasTextureCoordinates_isLeftAsItIs() {
        float[] texture = new float[24];
        Arrays.fill(texture, 12, 24, Float.NaN);
        Scene cut = QuadSplitter.cut(rectangles(12, 1, texture), EVERYTHING).scene();
        assertEquals(2 + 24, cut.triangles());
        assertEquals(6 * 26, cut.textureCoordinates().length);
        assertEquals(0, cut.textureCoordinates()[0]);
        assertTrue(Float.isNaN(cut.textureCoordinates()[6 * 2]));
    }

    @Test
    void folded_isNotAQuadrangle() {
        double[] points = {0, 0, 0, 12, 0, 0, 12, 1, 0, 0, 1, 1};
        Scene folded = new Scene("folded", points, new int[] {0, 1, 2, 0, 2, 3}, new int[2], List.of(GREY), List.of(),
                Optional.empty());
        assertSame(folded, QuadSplitter.cut(folded, EVERYTHING).scene());
    }

    private static double normalZ(Scene scene, int t) {
        return scene.corner(t, 1).minus(scene.corner(t, 0)).cross(scene.corner(t, 2).minus(scene.corner(t, 0))).z();
    }
}
