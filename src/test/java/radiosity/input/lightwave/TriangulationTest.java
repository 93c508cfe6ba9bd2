package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.IntList;
import radiosity.input.file.WorkBudget;
import radiosity.input.lightwave.lwo.Layer;
import radiosity.input.polygon.Triangulation;

/** The triangles of a polygon cover it exactly: their areas add up to its own, and no border is lost. */
class TriangulationTest {

    /** Name, x and y of the corners, area. */
    static Stream<Arguments> polygons() {
        return Stream.of(
                Arguments.of("arrow head", new double[] {0, 0, 2, 1, 0, 2, 0.5, 1}, 1.5),
                Arguments.of("L", new double[] {0, 0, 2, 0, 2, 1, 1, 1, 1, 3, 0, 3}, 4),
                Arguments.of("square with corners on its sides", new double[] {0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2,
                    0, 1}, 4),
                Arguments.of("square with a square hole", new double[] {0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 1, 1, 1, 3, 3, 3,
                    3, 1, 1, 1}, 12),
                Arguments.of("two holes",
                        new double[] {0, 0, 6, 0, 6, 3, 0, 3, 0, 0, 1, 1, 1, 2, 2, 2, 2, 1, 1, 1, 0, 0,
                    0, 0, 4, 1, 4, 2, 5, 2, 5, 1, 4, 1, 0, 0}, 16),
                Arguments.of("hole that touches the border", new double[] {0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 1, 3, 2, 1},
                        16 - 2.5),
                Arguments.of("spikes in and out", new double[] {0, 0, 2, 0, 3, 0, 2, 0, 2, 2, 1, 1, 2, 2, 0, 2}, 4),
                Arguments.of("zigzag", new double[] {0, 0, 1, 3, 2, 0, 3, 3, 4, 0, 4, 5, 3, 4, 2, 5, 1, 4, 0, 5}, 12),
                Arguments.of("pentagram", new double[] {0, 1, 0.588, -0.809, -0.951, 0.309, 0.951, 0.309, -0.588,
                    -0.809}, Double.NaN));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("polygons")
    void triangles_haveThePolygonsArea(String name, double[] xy, double area) {
        for (int axis = 0; axis < 3; axis++) {
            for (int direction : new int[] {1, -1}) {
                for (int start = 0; start < xy.length / 2; start++) {
                    assertCovered(layer(xy, axis, direction, start), area);
                }
            }
        }
    }

    private static void assertCovered(Layer layer, double area) {
        IntList triangles = new IntList();
        List<String> told = new ArrayList<>();
        new Triangulation(layer.points, layer.polygons, polygon -> "layer " + layer.number, new WorkBudget(),
                new Diagnostics("", told::add, false)).cut(0, triangles);
        double sum = 0;
        for (int i = 0; i < triangles.size(); i += 3) {
            IntList one = new IntList();
            one.add(triangles.get(i));
            one.add(triangles.get(i + 1));
            one.add(triangles.get(i + 2));
            sum += PolygonAreas.ofTriangles(layer, one).length();
        }
        double signed = PolygonAreas.ofPolygon(layer, 0).length();
        assertEquals(signed, PolygonAreas.ofTriangles(layer, triangles).length(), 1e-6 * signed);
        if (!Double.isNaN(area)) {
            assertEquals(area, sum, 1e-6 * area);
        }
    }

    /** The polygon in a plane across an axis, begun at some corner, forwards or backwards. */
    private static Layer layer(double[] xy, int axis, int direction, int start) {
        Layer layer = new Layer(0);
        int n = xy.length / 2;
        for (int i = 0; i < n; i++) {
            int from = Math.floorMod(start + direction * i, n);
            float[] p = new float[3];
            p[axis] = 7;
            p[(axis + 1) % 3] = (float) xy[2 * from];
            p[(axis + 2) % 3] = (float) xy[2 * from + 1];
            for (float x : p) {
                layer.points.add(x);
            }
            layer.polygons.corner(i);
        }
        layer.polygons.close(0);
        return layer;
    }

    @Test
    void convexQuad_isCutFromItsFirstCorner() {
        Layer layer = layer(new double[] {0, 0, 1, 0, 1, 1, 0, 1}, 2, 1, 0);
        IntList triangles = new IntList();
        new Triangulation(layer.points, layer.polygons, polygon -> "layer " + layer.number, new WorkBudget(),
                new Diagnostics("", w -> { }, false)).cut(0, triangles);
        assertEquals(List.of(0, 1, 2, 0, 2, 3), java.util.Arrays.stream(triangles.toArray()).boxed().toList());
    }

    @Tag("slow")
    @Test
    void cutting_isBoundedForAWholeScene() {
        WorkBudget work = new WorkBudget();
        int cut = 0;
        for (int i = 0; i < 40; i++) {
            IntList triangles = new IntList();
            Layer random = randomPolygon(20_000);
            new Triangulation(random.points, random.polygons, polygon -> "", work, new Diagnostics("", w -> { }, false))
                    .cut(0, triangles);
            cut += triangles.size() > 0 ? 1 : 0;
        }
        assertTrue(cut < 40, "40 tangles of 20,000 corners were all cut");
        assertTrue(work.isSpent());
    }

    private static Layer randomPolygon(int n) {
        java.util.Random random = new java.util.Random(5);
        double[] xy = random.doubles(2L * n).toArray();
        return layer(xy, 2, 1, 0);
    }
}
