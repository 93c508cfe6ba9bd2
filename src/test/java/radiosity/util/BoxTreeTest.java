package radiosity.util;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import radiosity.scene.Vec3;

class BoxTreeTest {

    private static Set<Integer> near(BoxTree tree, double[] a, double[] b, double near) {
        Set<Integer> found = new HashSet<>();
        tree.near(a, b, near, i -> assertTrue(found.add(i), "found twice"));
        return found;
    }

    private static double[] point(double[] points, int i) {
        return new double[] {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
    }

    private static double distance(double[] a, double[] b, double[] p) {
        Vec3 start = new Vec3(a[0], a[1], a[2]);
        Vec3 along = new Vec3(b[0], b[1], b[2]).minus(start);
        Vec3 to = new Vec3(p[0], p[1], p[2]).minus(start);
        double square = along.dot(along);
        double t = square > 0 ? Math.max(0, Math.min(1, along.dot(to) / square)) : 0;
        return to.minus(along.times(t)).length();
    }

    @Test
    void everyPointNearASegment_isFound() {
        Random random = new Random(1);
        for (int n : new int[] {1, 7, 8, 9, 100, 1000}) {
            double[] points = random.doubles(3L * n).map(x -> Math.rint(8 * x) / 8).toArray();
            BoxTree tree = BoxTree.ofPoints(points);
            for (int query = 0; query < 100; query++) {
                double[] a = random.doubles(3).toArray();
                double[] b = query % 2 == 0 ? a : random.doubles(3).toArray();
                Set<Integer> found = near(tree, a, b, .1);
                for (int i = 0; i < n; i++) {
                    double d = distance(a, b, point(points, i));
                    assertTrue(d > .1 || found.contains(i), "missed");
                    assertTrue(d < .2 || !found.contains(i), "far away: " + d);
                }
            }
        }
    }

    @Test
    void boxesThatReachThePoint_areFound() {
        double[] boxes = {0, 0, 0, 1, 1, 1, .5, .5, .5, 2, 2, 2, 3, 3, 3, 3, 3, 3};
        double[] p = {.75, .75, .75};
        assertEquals(Set.of(0, 1), near(new BoxTree(boxes), p, p, 0));
    }

    @Test
    void equalPoints_areAllFound() {
        double[] p = {0, 0, 0};
        assertEquals(1000, near(BoxTree.ofPoints(new double[3000]), p, p, 0).size());
    }

    @Test
    void lowestNearAPoint_isTheLowestOfAllThere() {
        Random random = new Random(2);
        double[] points = random.doubles(3000).map(x -> Math.rint(4 * x) / 4).toArray();
        BoxTree tree = BoxTree.ofPoints(points);
        for (int query = 0; query < 200; query++) {
            double[] p = random.doubles(3).map(x -> 1.5 * x).toArray();
            assertEquals(near(tree, p, p, .1).stream().min(Integer::compare).orElse(-1), tree.lowest(p, .1));
        }
        assertEquals(-1, new BoxTree(new double[0]).lowest(new double[3], 1));
    }

    @Test
    void lowestOfManyEqualPoints_isFoundWithoutLookingAtAll() {
        int[] looks = new int[1];
        BoxTree tree = BoxTree.ofPoints(new double[30_000]);
        assertEquals(0, tree.lowest((boxes, at) -> ++looks[0] > 0));
        assertTrue(looks[0] < 50, "looks: " + looks[0]);
    }

    @Test
    void emptyTree_findsNothing() {
        assertEquals(Set.of(), near(new BoxTree(new double[0]), new double[3], new double[3], 1));
    }
}
