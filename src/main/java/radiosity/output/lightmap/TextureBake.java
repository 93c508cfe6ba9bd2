package radiosity.output.lightmap;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import radiosity.output.image.Picture;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Rgb;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.DisjointSets;

/** Bakes the radiosity of all elements into one texture for each side of a surface (section 4.6 of the paper). */
public final class TextureBake {

    /** Largest width and height of a texture, texels: a size that old OpenGL implementations can show, too. */
    public static final int LARGEST_TEXTURE = 8192;

    /** Up to this width and height, texels, charts get as many texels as the images on them have pixels. */
    private static final int LARGEST_FOR_IMAGES = 2048;

    private final Solution solution;
    private final Vec3 origin;
    private final double samples;
    /** Connected, plane parts as sets of vertices; a part is named by its lowest vertex. */
    private final DisjointSets parts;

    /**
     * One side of a surface with all its triangles.
     *
     * @param surface   material of the side
     * @param back      whether this is the back of a two-sided surface
     * @param positions x, y, z relative to the origin, 3 per vertex, scene units; 3 vertices per original triangle
     * @param places    u, v in the texture, v downwards, 2 per vertex, in [0, 1]
     * @param radiosity the texture, W/m²
     */
    public record Baked(Surface surface, boolean back, float[] positions, float[] places, Picture radiosity) { }

    /**
     * @param origin  subtracted from all positions, scene units
     * @param samples texels per scene unit, above 0; a surface whose images are finer gets more
     */
    public TextureBake(Solution solution, Vec3 origin, double samples) {
        this.solution = solution;
        this.origin = origin;
        this.samples = samples;
        parts = new DisjointSets(solution.vertices(), solution.corners());
        joinFaces();
    }

    /** Joins the elements of each face to one part: a face that was cut has pieces with vertices of their own. */
    private void joinFaces() {
        Map<Integer, Integer> vertexOf = new HashMap<>();
        for (int e = 0; e < solution.elements(); e++) {
            int vertex = solution.corners()[3 * e];
            Integer other = vertexOf.putIfAbsent(solution.faceOf()[e], vertex);
            if (other != null) {
                parts.join(other, vertex);
            }
        }
    }

    /** Is given the sides of surfaces, one after the other. */
    public interface Taker {
        void take(Baked side) throws IOException;
    }

    /**
     * Bakes the sides of all surfaces, front before back, in the order of the scene's surfaces. A texture may take 805
     * MB, so each side is handed to the taker before the next one is baked, and is not kept here.
     *
     * @throws IOException if a texture would be wider or higher than {@value #LARGEST_TEXTURE} texels, or from the
     *         taker
     */
    public void bake(Taker taker) throws IOException {
        int[][] sides = Mesh.bySide(solution);
        for (int side = 0; side < sides.length; side++) {
            if (sides[side].length > 0) {
                taker.take(bake(solution.scene().surfaces().get(side >> 1), (side & 1) == 1, sides[side]));
            }
        }
    }

    private Baked bake(Surface surface, boolean back, int[] elements) throws IOException {
        Map<Integer, List<Integer>> byPart = new LinkedHashMap<>();
        for (int e : elements) {
            byPart.computeIfAbsent(parts.of(solution.corners()[3 * e]), p -> new ArrayList<>()).add(e);
        }
        List<List<Integer>> partElements = List.copyOf(byPart.values());
        List<Chart> charts = charts(partElements);
        ShelfPacker shelves = new ShelfPacker(charts);
        if (Math.max(shelves.width, shelves.height) > LARGEST_TEXTURE) {
            throw new IOException("-ut, surface " + surface.name() + ": expected a texture of at most "
                    + LARGEST_TEXTURE
                    + " texels, got " + shelves.width + "x" + shelves.height + "; give fewer samples");
        }
        Texels texels = new Texels(shelves.width, shelves.height);
        List<float[]> triangles = new ArrayList<>();
        for (int c = 0; c < charts.size(); c++) {
            for (int e : partElements.get(c)) {
                draw(texels, charts.get(c), shelves.x[c], shelves.y[c], e);
            }
            int chart = c;
            partElements.get(c).stream().map(e -> solution.faceOf()[e]).distinct()
                    .forEach(face -> triangles.add(triangle(face, charts.get(chart), shelves, chart)));
        }
        return baked(surface, back, triangles, texels.padded(Chart.PAD));
    }

    /**
     * One chart per part, as fine as the images on the part; all charts coarser if they do not fit into one texture.
     */
    private List<Chart> charts(List<List<Integer>> parts) {
        List<Chart> charts = List.of();
        for (int most = LARGEST_FOR_IMAGES; most > 0; most /= 2) {
            int texels = most;
            charts = parts.stream().map(part -> chart(part, texels)).toList();
            ShelfPacker shelves = new ShelfPacker(charts);
            if (Math.max(shelves.width, shelves.height) <= LARGEST_TEXTURE) {
                return charts;
            }
        }
        return charts;
    }

    /** @param most width and height, texels, up to which the chart is made as fine as the images on it */
    private Chart chart(List<Integer> elements, int most) {
        int face = solution.faceOf()[elements.get(0)];
        Vec3 along = corner(face, 1).minus(corner(face, 0));
        List<Vec3> points = elements.stream().map(e -> solution.faceOf()[e]).distinct()
                .flatMap(f -> IntStream.range(0, 3).mapToObj(k -> corner(f, k))).toList();
        Vec3 normal = Elements.normal(solution, elements.get(0));
        double finest = elements.stream().map(e -> solution.faceOf()[e] >> 1).distinct()
                .filter(solution.scene()::isMapped).mapToDouble(solution.scene()::pixelsPerUnit).max().orElse(0);
        return Chart.of(along, normal, points, samples, finest, most);
    }

    private Vec3 corner(int face, int k) {
        return Elements.corner(solution.scene(), face, k);
    }

    private void draw(Texels texels, Chart chart, int left, int top, int element) {
        double[] x = new double[3];
        double[] y = new double[3];
        Rgb[] h = new Rgb[3];
        for (int k = 0; k < 3; k++) {
            Vec3 p = Elements.corner(solution, element, k);
            x[k] = left + chart.x(p);
            y[k] = top + chart.y(p);
            h[k] = solution.irradianceAt(solution.corners()[3 * element + k]);
        }
        int triangle = solution.faceOf()[element] >> 1;
        texels.draw(x, y, (v, w) -> solution.scene().look(triangle, Elements.point(solution, element, v, w))
                .radiosity(h[0].times(1 - v - w).plus(h[1].times(v)).plus(h[2].times(w))));
    }

    /** x, y, z, u, v of each corner of a face, 15 numbers. */
    private float[] triangle(int face, Chart chart, ShelfPacker shelves, int c) {
        float[] vertices = new float[15];
        for (int k = 0; k < 3; k++) {
            Vec3 corner = corner(face, k);
            Vec3 p = corner.minus(origin);
            vertices[5 * k] = (float) p.x();
            vertices[5 * k + 1] = (float) p.y();
            vertices[5 * k + 2] = (float) p.z();
            vertices[5 * k + 3] = (float) ((shelves.x[c] + chart.x(corner)) / shelves.width);
            vertices[5 * k + 4] = (float) ((shelves.y[c] + chart.y(corner)) / shelves.height);
        }
        return vertices;
    }

    private static Baked baked(Surface surface, boolean back, List<float[]> triangles, Picture texture) {
        float[] positions = new float[9 * triangles.size()];
        float[] places = new float[6 * triangles.size()];
        for (int i = 0; i < 3 * triangles.size(); i++) {
            System.arraycopy(triangles.get(i / 3), i % 3 * 5, positions, 3 * i, 3);
            System.arraycopy(triangles.get(i / 3), i % 3 * 5 + 3, places, 2 * i, 2);
        }
        return new Baked(surface, back, positions, places, texture);
    }
}
