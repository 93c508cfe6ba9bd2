package radiosity.mesh.face;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FlatTriangleTest {

    private static final float[] TRIANGLE = {0, 0, 0, .3f, 0, 0, 0, .3f, 0};

    /** x and y of the second triangle's corners. */
    @ParameterizedTest
    @CsvSource({
        "the same, false, 0, 0, .3, 0, 0, .3", "turned over, false, 0, 0, 0, .3, .3, 0",
        "inside, false, .1, .1, .12, .1, .1, .12", "around, false, -1, -1, 2, -1, -1, 2",
        "across a corner, false, -.1, .2, .2, -.1, -.1, -.1", "shares an edge, true, .3, 0, .3, .3, 0, .3",
        "shares a corner, true, .3, 0, .5, 0, .5, .2", "beyond, true, .2, .2, .4, .2, .2, .4",
        "a line, true, .1, .1, .2, .1, .15, .1"})
    void triangles_areApartWhereTheyShareNoArea(String where, boolean areApart, float ax, float ay, float bx, float by,
            float cx, float cy) {
        float[] other = {ax, ay, 0, bx, by, 0, cx, cy, 0};
        assertEquals(areApart, areApart(TRIANGLE, other), where);
        assertEquals(areApart, areApart(other, TRIANGLE), where);
    }

    private static boolean areApart(float[] a, float[] b) {
        return new FlatTriangle(a).hasBeyondAnEdge(b, 0) || new FlatTriangle(b).hasBeyondAnEdge(a, 0);
    }
}
