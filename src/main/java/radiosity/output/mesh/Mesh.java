package radiosity.output.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.IntStream;
import radiosity.scene.Hierarchy;
import radiosity.scene.Lamp;
import radiosity.scene.MaterialSample;
import radiosity.scene.Rgb;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/**
 * One side of one surface of one object as the scene file holds it: indexed triangles with light at their vertices.
 *
 * @param surface     material of the side
 * @param node        index of the object's node in the scene's hierarchy; -1 for triangles without a node
 * @param back        whether this is the back of a two-sided surface
 * @param positions   x, y, z relative to the file's origin, 3 per vertex, scene units
 * @param normals     unit normals out of the visible side, 3 per vertex
 * @param irradiance  H for red, green and blue, 3 per vertex, W/m²
 * @param radiosity   B = E + rho H, 3 per vertex, W/m²
 * @param reflectance rho, 3 per vertex, if rho varies over the surface; else empty, and the surface's rho holds
 *                    everywhere
 * @param layers      irradiance from each lamp, one array of 3 per vertex for each lamp, W/m²; empty without layers
 * @param corners     vertices, 3 per element, counter-clockwise seen from the visible side
 * @param smoothing   the vertices that are shown with one irradiance
 */
public record Mesh(Surface surface, int node, boolean back, float[] positions, float[] normals,
                   float[] irradiance, float[] radiosity, float[] reflectance, List<float[]> layers, int[] corners,
                   SmoothShading smoothing) {

    public Mesh {
        layers = List.copyOf(layers);
    }

    /** A mesh whose facets are not joined, whatever its surface. */
    public Mesh(Surface surface, int node, boolean back, float[] positions, float[] normals, float[] irradiance,
                float[] radiosity, float[] reflectance, List<float[]> layers, int[] corners) {
        this(surface, node, back, positions, normals, irradiance, radiosity, reflectance, layers, corners,
                SmoothShading.NONE);
    }

    /** This mesh with its facets joined by the smoothing angle of its surface. */
    public Mesh smoothed() {
        return new Mesh(surface, node, back, positions, normals, irradiance, radiosity, reflectance, layers, corners,
                SmoothShading.of(this));
    }

    /**
     * Radiosity as it is shown, 3 per vertex, W/m²: with the mean irradiance of joined vertices; the same array as
     * {@code radiosity} where none are joined. Not to be modified.
     */
    public float[] shown() {
        if (smoothing.isFlat()) {
            return radiosity;
        }
        double[] means = smoothing.means(irradiance);
        float[] shown = new float[radiosity.length];
        for (int i = 0; i < shown.length; i++) {
            shown[i] = (float) (radiosity[i] + reflectance(i) * (means[i] - irradiance[i]));
        }
        return shown;
    }

    public int vertices() {
        return positions.length / 3;
    }

    public int elements() {
        return corners.length / 3;
    }

    /** Position of corner k (0, 1 or 2) of an element, relative to the file's origin, scene units. */
    public Vec3 position(int element, int k) {
        int i = 3 * corners[3 * element + k];
        return new Vec3(positions[i], positions[i + 1], positions[i + 2]);
    }

    /** Vector normal to an element out of its visible side, twice as long as its area is large, square scene units. */
    public Vec3 cross(int element) {
        Vec3 a = position(element, 0);
        return position(element, 1).minus(a).cross(position(element, 2).minus(a));
    }

    /** Radiosity B at corner k (0, 1 or 2) of an element, W/m². */
    public Rgb radiosity(int element, int k) {
        return at(radiosity, corners[3 * element + k]);
    }

    /** Irradiance H at corner k (0, 1 or 2) of an element, W/m². */
    public Rgb irradiance(int element, int k) {
        return at(irradiance, corners[3 * element + k]);
    }

    /**
     * This mesh in the light of lamps that are dimmed or coloured.
     *
     * @param lamps   the lamps of the layers, in the order of the layers
     * @param factors by which the light of each lamp is multiplied, one per lamp, each channel at least 0
     */
    public Mesh mixed(List<Lamp> lamps, List<Rgb> factors) {
        Surface lit = lit(lamps, factors);
        float[] h = new float[irradiance.length];
        float[] b = new float[irradiance.length];
        for (int i = 0; i < h.length; i++) {
            double sum = 0;
            for (int layer = 0; layer < lamps.size(); layer++) {
                sum += factors.get(layer).channel(i % 3) * layers.get(layer)[i];
            }
            h[i] = (float) sum;
            b[i] = (float) (exitance(i) * dimmed(lit, i % 3) + reflectance(i) * sum);
        }
        return new Mesh(lit, node, back, positions, normals, h, b, reflectance, layers, corners,
                smoothing);
    }

    private double reflectance(int i) {
        return reflectance.length > 0 ? reflectance[i] : surface.reflectance().channel(i % 3);
    }

    /** Exitance of entry i (3 * vertex + channel), W/m²: radiosity minus reflected light if rho varies. */
    private double exitance(int i) {
        return reflectance.length > 0 ? Math.max(0, radiosity[i] - (double) reflectance[i] * irradiance[i])
                : surface.exitance().channel(i % 3);
    }

    /** Dimmed exitance of the surface over its original exitance; 1 where the surface emits nothing. */
    private double dimmed(Surface lit, int channel) {
        double before = surface.exitance().channel(channel);
        return before == 0 ? 1 : lit.exitance().channel(channel) / before;
    }

    /** The surface with its exitance multiplied by the factor of the lamp that it is, if it is one of the lamps. */
    private Surface lit(List<Lamp> lamps, List<Rgb> factors) {
        Rgb exitance = surface.exitance();
        for (int layer = 0; layer < lamps.size(); layer++) {
            if (lamps.get(layer).isSurface(surface.name())) {
                exitance = exitance.times(factors.get(layer));
            }
        }
        return surface.with(exitance);
    }

    /** Reflectance rho at corner k (0, 1 or 2) of an element. */
    public Rgb reflectance(int element, int k) {
        return reflectance.length > 0 ? at(reflectance, corners[3 * element + k]) : surface.reflectance();
    }

    private static Rgb at(float[] array, int vertex) {
        return new Rgb(array[3 * vertex], array[3 * vertex + 1], array[3 * vertex + 2]);
    }

    /**
     * Divides a solution into meshes, sorted by surface, front before back, then by node; there are no empty meshes.
     *
     * @param origin subtracted from all positions, scene units
     * @throws IllegalArgumentException if a position or the light at a vertex is NaN
     */
    public static List<Mesh> of(Solution solution, Vec3 origin) {
        int[][] sides = bySide(solution);
        int[] local = new int[solution.vertices()];
        Arrays.fill(local, -1);
        List<Mesh> meshes = new ArrayList<>();
        for (int side = 0; side < sides.length; side++) {
            Surface surface = solution.scene().surfaces().get(side >> 1);
            for (Map.Entry<Integer, int[]> part : byNode(solution, sides[side]).entrySet()) {
                meshes.add(of(solution, origin, surface, part.getKey(), (side & 1) == 1, part.getValue(), local));
            }
        }
        return meshes;
    }

    /** Groups elements by node (-1 for none); the order of the given elements stays within each group. */
    static SortedMap<Integer, int[]> byNode(Solution solution, int[] elements) {
        SortedMap<Integer, int[]> parts = new TreeMap<>();
        Hierarchy hierarchy = solution.scene().hierarchy().written();
        int[] nodes = Arrays.stream(elements).map(e -> hierarchy.of(solution.faceOf()[e] >> 1)).toArray();
        SortedMap<Integer, Integer> counts = new TreeMap<>();
        for (int node : nodes) {
            counts.merge(node, 1, Integer::sum);
        }
        counts.forEach((node, count) -> parts.put(node, new int[count]));
        for (int i = elements.length - 1; i >= 0; i--) {
            parts.get(nodes[i])[counts.merge(nodes[i], -1, Integer::sum)] = elements[i];
        }
        return parts;
    }

    /** Elements of each side, ascending: entry 2 * surface for its front, entry 2 * surface + 1 for its back. */
    public static int[][] bySide(Solution solution) {
        int[] count = new int[2 * solution.scene().surfaces().size()];
        for (int face : solution.faceOf()) {
            count[side(solution, face)]++;
        }
        int[][] elements = Arrays.stream(count).mapToObj(int[]::new).toArray(int[][]::new);
        Arrays.fill(count, 0);
        for (int e = 0; e < solution.elements(); e++) {
            int side = side(solution, solution.faceOf()[e]);
            elements[side][count[side]++] = e;
        }
        return elements;
    }

    private static int side(Solution solution, int face) {
        return 2 * solution.scene().surfaceOf()[face >> 1] + (face & 1);
    }

    /** @param local working memory: -1 per vertex of the solution, before and after the call */
    private static Mesh of(Solution solution, Vec3 origin, Surface surface, int node, boolean back, int[] elements,
                           int[] local) {
        int[] corners = new int[3 * elements.length];
        int[] vertices = new int[3 * elements.length];
        int[] firstElement = new int[3 * elements.length];
        int count = 0;
        for (int i = 0; i < corners.length; i++) {
            int v = solution.corners()[3 * elements[i / 3] + i % 3];
            if (local[v] < 0) {
                firstElement[count] = elements[i / 3];
                vertices[count] = v;
                local[v] = count++;
            }
            corners[i] = local[v];
        }
        boolean varied = !surface.maps().isEmpty()
                || Arrays.stream(elements).anyMatch(e -> solution.scene().isColoured(solution.faceOf()[e] >> 1));
        Mesh mesh = new Mesh(surface, node, back, new float[3 * count], new float[3 * count], new float[3 * count],
                new float[3 * count], new float[varied ? 3 * count : 0], layers(solution.lamps().size(), 3 * count),
                corners);
        MaterialSample[] looks = mesh.looks(solution, elements);
        for (int i = 0; i < count; i++) {
            mesh.put(i, solution, vertices[i], origin, Elements.normal(solution, firstElement[i]), looks[i]);
            local[vertices[i]] = -1;
        }
        return mesh.smoothed();
    }

    private static List<float[]> layers(int count, int length) {
        return IntStream.range(0, count).mapToObj(layer -> new float[length]).toList();
    }

    /** 1 per vertex: the surface's material or, if it varies, the mean over the elements around the vertex. */
    private MaterialSample[] looks(Solution solution, int[] elements) {
        MaterialSample[] looks = new MaterialSample[vertices()];
        Arrays.fill(looks, new MaterialSample(surface.exitance(), surface.reflectance()));
        if (reflectance.length == 0) {
            return looks;
        }
        Arrays.fill(looks, new MaterialSample(Rgb.BLACK, Rgb.BLACK));
        int[] count = new int[looks.length];
        for (int i = 0; i < corners.length; i++) {
            MaterialSample sum = looks[corners[i]];
            MaterialSample element = solution.material(elements[i / 3]);
            looks[corners[i]] = new MaterialSample(sum.exitance().plus(element.exitance()), sum.reflectance()
                    .plus(element.reflectance()));
            count[corners[i]]++;
        }
        for (int v = 0; v < looks.length; v++) {
            looks[v] = new MaterialSample(looks[v].exitance().times(1.0 / count[v]), looks[v].reflectance()
                    .times(1.0 / count[v]));
        }
        return looks;
    }

    private void put(int i, Solution solution, int vertex, Vec3 origin, Vec3 normal, MaterialSample look) {
        double[] x = solution.positions();
        put(positions, i, x[3 * vertex] - origin.x(), x[3 * vertex + 1] - origin.y(), x[3 * vertex + 2] - origin.z());
        put(normals, i, normal.x(), normal.y(), normal.z());
        Rgb h = solution.irradianceAt(vertex);
        put(irradiance, i, h);
        put(radiosity, i, look.radiosity(h));
        if (reflectance.length > 0) {
            put(reflectance, i, look.reflectance());
        }
        for (int layer = 0; layer < layers.size(); layer++) {
            put(layers.get(layer), i, solution.irradianceAt(vertex, layer));
        }
    }

    private static void put(float[] array, int i, Rgb light) {
        put(array, i, light.r(), light.g(), light.b());
    }

    private static void put(float[] array, int i, double... xyz) {
        for (int a = 0; a < 3; a++) {
            if (Double.isNaN(xyz[a])) {
                throw new IllegalArgumentException("vertex " + i + ": expected a number, got NaN");
            }
            array[3 * i + a] = (float) Math.max(-Float.MAX_VALUE, Math.min(Float.MAX_VALUE, xyz[a]));
        }
    }
}
