package radiosity.output.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import radiosity.output.gltf.Handmade;
import radiosity.output.points.Points;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

class TJunctionsTest {

    private static final Rgb NONE = Rgb.BLACK;

    /** How often each directed edge occurs more than its reverse; edges by the exact positions of their ends. */
    private static Map<List<Vec3>, Integer> cracks(Solution s) {
        Map<List<Vec3>, Integer> balance = new HashMap<>();
        for (int e = 0; e < s.elements(); e++) {
            for (int k = 0; k < 3; k++) {
                Vec3 a = Elements.corner(s, e, k);
                Vec3 b = Elements.corner(s, e, (k + 1) % 3);
                balance.merge(List.of(a, b), 1, Integer::sum);
                balance.merge(List.of(b, a), -1, Integer::sum);
            }
        }
        balance.values().removeIf(n -> n == 0);
        return balance;
    }

    private static double area(Solution s) {
        double area = 0;
        for (int e = 0; e < s.elements(); e++) {
            area += Elements.cross(s, e).length() / 2;
        }
        return area;
    }

    private static Rgb valueAt(Solution s, int element, Vec3 p) {
        return new Points(s).at(p, Elements.normal(s, element)).irradiance();
    }

    @Test
    void room_whoseWallsAreDividedDifferently_isWatertight() {
        Solution open = Handmade.room(new Vec3(.1, .2, .3), 1.7, p -> NONE).solution();
        assertTrue(cracks(open).size() > 100);
        Solution closed = TJunctions.close(open);
        assertEquals(Map.of(), cracks(closed));
        assertEquals(area(open), area(closed), 1e-12);
        for (int e = 0; e < closed.elements(); e++) {
            assertTrue(Elements.cross(closed, e).dot(Elements.normal(closed, e)) > 1e-6, "element " + e);
        }
    }

    @Test
    void tiltedRoom_whoseEdgesAgreeOnlyButForRounding_isWatertight() {
        Solution room = Handmade.room(new Vec3(-.5, -.5, -.5), 1, p -> NONE).solution();
        double[] x = room.positions();
        for (int i = 0; i < x.length; i += 3) {
            Vec3 p = turned(new Vec3(x[i], x[i + 1], x[i + 2]), 1 + (i % 7 - 3) * 1e-8);
            x[i] = p.x();
            x[i + 1] = p.y();
            x[i + 2] = p.z();
        }
        assertEquals(Map.of(), cracks(TJunctions.close(room)));
    }

    private static Vec3 turned(Vec3 p, double scale) {
        Vec3 x = new Vec3(.36, .48, -.8).times(scale);
        Vec3 y = new Vec3(-.8, .6, 0).times(scale);
        return new Vec3(p.dot(x), p.dot(y), p.dot(x.cross(y)));
    }

    @Test
    void closedSolution_staysAsItIs() {
        Solution once = TJunctions.close(Handmade.room(Vec3.ZERO, 1, p -> new Rgb(p.x(), p.y(), p.z())).solution());
        Solution twice = TJunctions.close(once);
        assertArrayEquals(once.corners(), twice.corners());
        assertArrayEquals(once.faceOf(), twice.faceOf());
        assertArrayEquals(once.positions(), twice.positions());
        assertArrayEquals(once.irradiance(), twice.irradiance());
    }

    /** Flux of one channel that arrives, W. */
    private static double flux(Solution s) {
        double flux = 0;
        for (int i = 0; i < 3 * s.elements(); i++) {
            flux += Elements.cross(s, i / 3).length() / 6 * s.irradiance()[s.channels() * s.corners()[i]];
        }
        return flux;
    }

    @Test
    void hangingVertices_addNoFlux() {
        for (double atMiddle : new double[] {1, 2, 3}) {
            Solution open = hangingInOnePart(atMiddle);
            Solution closed = TJunctions.close(open);
            assertEquals(open.elements() + 1, closed.elements());
            assertEquals(flux(open), flux(closed), 1e-12);
        }
    }

    @Test
    void conformingSolution_losesNoBit() {
        Handmade made = new Handmade();
        made.grid(made.surface("s", .5), Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0), 9, 9,
                p -> new Rgb(p.x(), 1 / (1 + p.y()), 3));
        Solution s = made.solution();
        Solution closed = TJunctions.close(s);
        assertArrayEquals(s.corners(), closed.corners());
        assertArrayEquals(s.positions(), closed.positions());
        assertArrayEquals(s.irradiance(), closed.irradiance());
    }

    /** One element above the edge from 0 to 1, two below it that meet at its middle, all in one part. */
    private static Solution hangingInOnePart(double atMiddle) {
        Handmade made = new Handmade();
        int t = 2 * made.triangle(made.surface("s", .5), Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0));
        int a = made.vertex(Vec3.ZERO, Rgb.grey(1));
        int b = made.vertex(new Vec3(1, 0, 0), Rgb.grey(3));
        int c = made.vertex(new Vec3(0, 1, 0), Rgb.grey(1));
        int middle = made.vertex(new Vec3(.5, 0, 0), Rgb.grey(atMiddle));
        int d = made.vertex(new Vec3(0, -1, 0), Rgb.grey(1));
        made.element(t, a, b, c);
        made.element(t, a, d, middle);
        made.element(t, middle, d, b);
        return made.solution();
    }

    @Test
    void vertexOfTheSamePart_bringsItsOwnValue() {
        Solution closed = TJunctions.close(hangingInOnePart(10));
        assertEquals(5, closed.vertices());
        assertEquals(4, closed.elements());
        double atMiddle = valueAt(closed, 0, new Vec3(.5, 0, 0)).r();
        assertEquals(10 - 4 / 3., atMiddle, 1e-12, "its own, less what it adds to the split element");
        assertEquals(atMiddle, valueAt(closed, 0, new Vec3(.5, -1e-9, 0)).r(), 1e-6);
    }

    /**
     * The two sides of a wall that stands free on a floor are one part, which goes round it, but have ends of their
     * own.
     */
    @Test
    void vertexBehindAWall_bringsItsPlaceAndNoLight() {
        Handmade made = new Handmade();
        int t = 2 * made.triangle(made.surface("s", .5), Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0));
        int[] ends = new int[4];
        Arrays.setAll(ends, i -> made.vertex(new Vec3(i % 2, 0, 0), Rgb.grey(1)));
        int before = made.vertex(new Vec3(.3, 1, 0), Rgb.grey(1));
        int behind = made.vertex(new Vec3(.3, -1, 0), Rgb.grey(1));
        int middle = made.vertex(new Vec3(.5, 0, 0), Rgb.grey(10));
        made.element(t, ends[0], ends[1], before);
        made.element(t, ends[2], behind, middle);
        made.element(t, middle, behind, ends[3]);
        made.element(t, behind, made.vertex(new Vec3(5, 0, 0), Rgb.grey(1)), before);
        Solution closed = TJunctions.close(made.solution());
        assertEquals(5, closed.elements());
        for (int e = 0; e < closed.elements(); e++) {
            List<Integer> corners = Arrays.stream(closed.corners(), 3 * e, 3 * e + 3).boxed().toList();
            assertEquals(corners.contains(middle), corners.contains(behind) && !corners.contains(before));
        }
    }

    @Test
    void vertexOfAnotherSurface_bringsItsPlaceAndNoLight() {
        Handmade made = new Handmade();
        made.grid(made.surface("big", .5), Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0), 1, 1,
                p -> new Rgb(1 + p.x(), 0, 5 * p.y()));
        made.grid(made.surface("small", .5), new Vec3(0, -1, 0), new Vec3(1, 0, 0), new Vec3(0, 1, 0), 3, 3,
                p -> Rgb.grey(100));
        Solution closed = TJunctions.close(made.solution());
        assertEquals(2 + 18 + 2, closed.elements());
        for (double x = .05; x < 1; x += .1) {
            assertEquals(1 + x, valueAt(closed, 0, new Vec3(x, 1e-4, 0)).r(), 1e-12);
            assertEquals(100, valueAt(closed, 0, new Vec3(x, -1e-4, 0)).r(), 1e-12);
        }
        assertEquals(1, closed.radiosityAt(0, 0).r() / .5, 1e-12);
    }

    @Test
    void vertexFromElsewhere_betweenSharedOnes_isInterpolatedBetweenThem() {
        Handmade made = new Handmade();
        int t = 2 * made.triangle(made.surface("s", .5), Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0));
        int a = made.vertex(Vec3.ZERO, Rgb.grey(0));
        int b = made.vertex(new Vec3(1, 0, 0), Rgb.grey(0));
        int c = made.vertex(new Vec3(0, 1, 0), Rgb.grey(0));
        int middle = made.vertex(new Vec3(.5, 0, 0), Rgb.grey(10));
        int d = made.vertex(new Vec3(0, -1, 0), Rgb.grey(0));
        made.element(t, a, b, c);
        made.element(t, a, d, middle);
        made.element(t, middle, d, b);
        made.grid(made.surface("post", .5), Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 0, 1), 4, 1, p -> Rgb.grey(77));
        Solution closed = TJunctions.close(made.solution());
        double between = valueAt(closed, 0, new Vec3(.5, 0, 0)).r() / 2;
        assertTrue(between > 1 && between < 5, "less than half of 10, which adds to the split element: " + between);
        assertEquals(between, valueAt(closed, 0, new Vec3(.25, 0, 0)).r(), 1e-12);
        assertEquals(between, valueAt(closed, 0, new Vec3(.75, 1e-5, 0)).r(), 1e-3);
        assertEquals(between, valueAt(closed, 0, new Vec3(.75, -1e-5, 0)).r(), 1e-3);
    }

    @Test
    void order_ofElementsAndVerticesBefore_isKept() {
        Solution open = Handmade.room(Vec3.ZERO, 1, p -> Rgb.grey(p.x())).solution();
        Solution closed = TJunctions.close(open);
        assertArrayEquals(open.positions(), Arrays.copyOf(closed.positions(), open.positions().length));
        int[] faces = Arrays.stream(closed.faceOf()).map(f -> f >> 2).toArray();
        int[] sorted = faces.clone();
        Arrays.sort(sorted);
        assertArrayEquals(sorted, faces);
    }

    @Test
    void emptySolution_staysEmpty() {
        assertEquals(0, TJunctions.close(new Handmade().solution()).elements());
    }
}
