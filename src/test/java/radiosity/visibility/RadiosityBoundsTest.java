package radiosity.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Vec3;
import radiosity.util.TooLargeException;

/** The hierarchy against a test of every triangle in double precision, and rays aimed at where triangles meet. */
class RadiosityBoundsTest {

    @Test
    void moreTrianglesThanAnArrayHolds_areRefusedWithTheirNumber() {
        assertEquals(534_773_760, BoundsLayout.length(1, 33_423_359));
        assertEquals("bounding volumes of 33,423,360 triangles: expected at most 534,773,760 numbers, got 534,773,776",
                assertThrows(TooLargeException.class, () -> BoundsLayout.length(1, 33_423_360)).getMessage());
    }

    /** Triangles of about 1/10 strewn through a cube of size 1. */
    private static float[] strewn(int n, Random random) {
        float[] corners = new float[9 * n];
        for (int i = 0; i < n; i++) {
            for (int a = 0; a < 3; a++) {
                float middle = random.nextFloat() - 0.5f;
                for (int k = 0; k < 3; k++) {
                    corners[9 * i + 3 * k + a] = middle + 0.1f * (random.nextFloat() - 0.5f);
                }
            }
        }
        return corners;
    }

    /**
     * Moeller and Trumbore in double: by how much a segment is inside the nearest triangle that its line meets between
     * its ends, or NaN. Small values either way are too close to call in floats.
     */
    private static double inside(float[] corners, int i, double[] o, double[] t) {
        double[] d = {t[0] - o[0], t[1] - o[1], t[2] - o[2]};
        double[] a = edge(corners, i, 3);
        double[] b = edge(corners, i, 6);
        double[] p = cross(d, b);
        double det = dot(a, p);
        double[] s = {o[0] - corners[9 * i], o[1] - corners[9 * i + 1], o[2] - corners[9 * i + 2]};
        double[] q = cross(s, a);
        double u = dot(s, p) / det;
        double v = dot(d, q) / det;
        double at = dot(b, q) / det;
        return Math.min(Math.min(Math.min(u, v), 1 - u - v), Math.min(at, 1 - at));
    }

    private static double[] edge(float[] corners, int i, int k) {
        return new double[] {(double) corners[9 * i + k] - corners[9 * i],
            (double) corners[9 * i + k + 1] - corners[9 * i + 1], (double) corners[9 * i + k + 2] - corners[9 * i + 2]};
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /** Half of the rays at right angles to one axis or two. */
    @ParameterizedTest
    @ValueSource(ints = {1, 5, 40, 700})
    void blocked_isWhatATestOfEveryTriangleSays(int triangles) {
        Random random = new Random(triangles);
        float[] corners = strewn(triangles, random);
        RadiosityBounds bounds = new RadiosityBounds(corners);
        int blocked = 0;
        for (int r = 0; r < 4000; r++) {
            double[] o = {random.nextFloat() - 0.5f, random.nextFloat() - 0.5f, random.nextFloat() - 0.5f};
            double[] t = {random.nextFloat() - 0.5f, random.nextFloat() - 0.5f, random.nextFloat() - 0.5f};
            for (int a = 0; a < r % 4 - 1; a++) {
                t[(r / 4 + a) % 3] = o[(r / 4 + a) % 3];
            }
            double deepest = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < triangles; i++) {
                deepest = Math.max(deepest, inside(corners, i, o, t));
            }
            if (Math.abs(deepest) > 1e-3) {
                assertEquals(deepest > 0, bounds.blocked((float) o[0], (float) o[1], (float) o[2],
                        (float) t[0], (float) t[1], (float) t[2]));
                blocked += deepest > 0 ? 1 : 0;
            }
        }
        assertTrue(triangles < 700 || blocked > 100, "some rays were blocked");
    }

    /** A bumpy sheet of n x n quadrangles of 1 / n in the plane y = 0, watertight. */
    private static float[] sheet(int n, float bump, Random random) {
        float[] height = new float[(n + 1) * (n + 1)];
        for (int i = 0; i < height.length; i++) {
            height[i] = bump * random.nextFloat();
        }
        float[] corners = new float[18 * n * n];
        int at = 0;
        int[][] order = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
        for (int i = 0; i < n * n; i++) {
            for (int[] step : order) {
                int x = i % n + step[0];
                int z = i / n + step[1];
                corners[at++] = (float) x / n - 0.5f;
                corners[at++] = height[z * (n + 1) + x];
                corners[at++] = (float) z / n - 0.5f;
            }
        }
        return corners;
    }

    /**
     * Away from the origin, where floats round, with rays long and short, steep and flat, but steeper than the bumps.
     */
    @ParameterizedTest
    @CsvSource({"1, 1, 0.5", "0.01, 0.01, 0.5", "0.01, 1, 0.5", "0.001, 1, 0.5", "0.01, 1, 0.05"})
    void noRay_passesBetweenNeighbours(float scale, float length, float steepness) {
        Random random = new Random(7);
        float[] corners = sheet(20, 0.01f * steepness, random);
        for (int i = 0; i < corners.length; i++) {
            corners[i] = 0.3f + scale * corners[i];
        }
        RadiosityBounds bounds = new RadiosityBounds(corners);
        int missed = 0;
        for (int r = 0; r < 100_000; r++) {
            int i = 9 * random.nextInt(corners.length / 9);
            int k = 3 * random.nextInt(3);
            int l = (k + 3) % 9;
            float w = r % 4 == 0 ? 0 : random.nextFloat();
            float[] to = new float[3];
            for (int a = 0; a < 3; a++) {
                to[a] = corners[i + k + a] + w * (corners[i + l + a] - corners[i + k + a]);
            }
            if (Math.abs(to[0] - 0.3f) > 0.49f * scale || Math.abs(to[2] - 0.3f) > 0.49f * scale) {
                continue;
            }
            float dx = length * (random.nextFloat() - 0.5f);
            float dy = length * steepness * (0.4f + random.nextFloat());
            float dz = length * (random.nextFloat() - 0.5f);
            missed += bounds.blocked(to[0] + dx, to[1] + dy, to[2] + dz, to[0] - dx, to[1] - dy, to[2] - dz) ? 0 : 1;
        }
        assertEquals(0, missed);
    }

    @Test
    void nearest_isTheFirstOfTwoSheets() {
        float[] two = {-1, 0, -1, -1, 0, 1, 1, 0, 0, -1, 0.5f, -1, -1, 0.5f, 1, 1, 0.5f, 0};
        float[] hit = new float[3];
        RadiosityBounds bounds = new RadiosityBounds(two);
        assertEquals(1, bounds.nearest(0, 1, 0, 0, -1, 0, 10, hit));
        assertEquals(0.5f, hit[0], 1e-6f);
        assertEquals(0, bounds.nearest(0, -1, 0, 0, 1, 0, 10, hit));
        assertEquals(-1, bounds.nearest(0, 1, 0, 0, -1, 0, 0.4f, hit));
        assertEquals(-1, new RadiosityBounds(new float[0]).nearest(0, 1, 0, 0, -1, 0, 10, hit));
    }

    @Test
    void aSegmentThatEndsOnATriangle_isNotBlockedByIt() {
        float[] one = {-1, 0, -1, -1, 0, 1, 1, 0, 0};
        RadiosityBounds bounds = new RadiosityBounds(one);
        assertEquals(false, bounds.blocked(0, 1, 0, 0, 0, 0));
        assertEquals(false, bounds.blocked(0, 0, 0, 0.3f, 1, 0.2f));
        assertEquals(true, bounds.blocked(0, 1, 0, 0, -1, 0));
    }

    /** Floors end at walls, and a receiving point of a small element lies as near as this to a wall before the sky. */
    @Test
    void pointBesideAWall_doesNotSeeTheSkyBehindIt() {
        RadiosityBounds wall = new RadiosityBounds(new float[] {.5f, -.5f, -.5f, .5f, .5f, -.5f, .5f, 0, .5f});
        Vec3 beside = new Vec3(.5 - 1e-5, 0, 0);
        for (Vec3 way : new Vec3[] {new Vec3(1, 0, 0), new Vec3(1, 1, -.5).unit(), new Vec3(1, -3, 1).unit()}) {
            assertFalse(wall.isFree(beside, way, new RadiosityBounds.Blocker()), "" + way);
            assertTrue(wall.isFree(beside, way.times(-1), new RadiosityBounds.Blocker()), "" + way);
        }
    }

    @Test
    void raysOutOfTheScene_areStoppedByWhatStopsSegments_whateverStoppedTheRayBefore() {
        Random random = new Random(3);
        RadiosityBounds bounds = new RadiosityBounds(strewn(600, random));
        RadiosityBounds.Blocker last = new RadiosityBounds.Blocker();
        int free = 0;
        for (int i = 0; i < 20_000; i++) {
            Vec3 from = new Vec3(random.nextFloat() - .5, random.nextFloat() - .5, random.nextFloat() - .5);
            Vec3 way = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            boolean isFree = bounds.isFree(from, way, last);
            assertEquals(bounds.isFree(from, way, new RadiosityBounds.Blocker()), isFree);
            assertEquals(!bounds.blocked(from, from.plus(way.times(4))), isFree, from + " " + way);
            free += isFree ? 1 : 0;
        }
        assertTrue(free > 2_000 && free < 18_000, free + " are free");
    }
}
