package radiosity.output.lightmap;

import java.io.IOException;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import radiosity.output.mesh.Elements;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.DisjointSets;

/**
 * Packs the charts of a solution's connected, plane parts into one texture, side by side on shelves from the top down,
 * the highest charts first, and says where points of the parts lie in the texture.
 */
final class Atlas {

    /** Largest width and height of a texture, texels: a size that browsers and old OpenGL implementations can show. */
    static final int LARGEST = 8192;

    private final List<Chart> charts;
    /** Size of the texture, texels. */
    private final int width;
    private final int height;
    /** Upper left corner of each chart in the order of the charts, texels. */
    private final int[] x;
    private final int[] y;

    /** @param charts not modified, but kept */
    Atlas(List<Chart> charts) {
        this.charts = charts;
        x = new int[charts.size()];
        y = new int[charts.size()];
        double area = charts.stream().mapToDouble(c -> (double) c.width() * c.height()).sum();
        int widest = charts.stream().mapToInt(Chart::width).max().orElse(1);
        width = Math.max(widest, (int) Math.ceil(Math.sqrt(area)));
        int right = 0;
        int top = 0;
        int shelf = 0;
        for (int c : IntStream.range(0, charts.size()).boxed()
                .sorted(Comparator.comparing(c -> -charts.get(c).height())).toList()) {
            if (right + charts.get(c).width() > width) {
                top += shelf;
                right = 0;
                shelf = 0;
            }
            x[c] = right;
            y[c] = top;
            right += charts.get(c).width();
            shelf = Math.max(shelf, charts.get(c).height());
        }
        height = Math.max(1, top + shelf);
    }

    /**
     * Connected, plane parts as sets of vertices. All elements of a face are in one part, because a face that was cut
     * has pieces with vertices of their own.
     */
    static DisjointSets parts(Solution solution) {
        DisjointSets parts = new DisjointSets(solution.vertices(), solution.corners());
        Map<Integer, Integer> vertexOf = new HashMap<>();
        for (int e = 0; e < solution.elements(); e++) {
            int vertex = solution.corners()[3 * e];
            parts.join(vertex, vertexOf.computeIfAbsent(solution.faceOf()[e], face -> vertex));
        }
        return parts;
    }

    boolean fits() {
        return Math.max(width, height) <= LARGEST;
    }

    /**
     * The texture, without light.
     *
     * @param option with which the message begins
     * @throws IOException if the texture is wider or higher than {@value #LARGEST} texels
     */
    Texels texels(String option) throws IOException {
        if (!fits()) {
            throw new IOException(option + ": expected a texture of at most " + LARGEST + " texels along an edge, got "
                    + width + "x" + height + "; give fewer");
        }
        return new Texels(width, height);
    }

    /** What is drawn at a point of an element: a function of the element, the point's weights, and the irradiance. */
    interface Drawn {
        Rgb at(int element, double v, double w, Rgb irradiance);
    }

    /**
     * Draws elements, then the texels beyond their edges: without these, parts narrower than a texel would stay black.
     *
     * @param elementsOf the elements of each chart
     */
    void draw(Texels texels, Solution solution, List<List<Integer>> elementsOf, Drawn drawn) {
        for (int c = 0; c < 2 * elementsOf.size(); c++) {
            int chart = c % elementsOf.size();
            for (int e : elementsOf.get(chart)) {
                Rgb[] h = new Rgb[3];
                Arrays.setAll(h, k -> solution.irradianceAt(solution.corners()[3 * e + k]));
                Texels.Light light = (v, w) -> drawn.at(e, v, w, Texels.within(h,
                        h[0].times(1 - v - w).plus(h[1].times(v)).plus(h[2].times(w))));
                double[][] at = corners(chart, solution, e);
                if (c < elementsOf.size()) {
                    texels.draw(at[0], at[1], light);
                } else {
                    texels.drawBeyond(at[0], at[1], light);
                }
            }
        }
    }

    /** The corners of an element on a chart: horizontal positions, then vertical ones, texels. */
    private double[][] corners(int chart, Solution solution, int element) {
        double[][] corners = new double[2][3];
        for (int k = 0; k < 3; k++) {
            Vec3 p = Elements.corner(solution, element, k);
            corners[0][k] = x[chart] + charts.get(chart).x(p);
            corners[1][k] = y[chart] + charts.get(chart).y(p);
        }
        return corners;
    }

    /** Writes the place of a point on a chart as u and v in [0, 1], v downwards, to two numbers of an array. */
    void place(int chart, Vec3 p, float[] places, int at) {
        places[at] = (float) ((x[chart] + charts.get(chart).x(p)) / width);
        places[at + 1] = (float) ((y[chart] + charts.get(chart).y(p)) / height);
    }
}
