package radiosity.output.model;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import radiosity.gltf.GltfModel;

/** The vertices of a primitive, each repeated for every further place at which it lies in the lightmap. */
final class VertexSplit {

    private final int count;
    private final int[] corners;
    /** Numbers of the repeated vertices, which follow the primitive's own, by the vertex repeated and the place. */
    private final Map<Key, Integer> more = new HashMap<>();
    private int[] repeated = new int[16];
    private float[] coordinates;

    private record Key(int vertex, float u, float v) { }

    /**
     * @param count  number of the primitive's vertices
     * @param place  the primitive at a node, with the scene's triangles of its corners
     * @param places u, v in the lightmap of each corner of the scene's triangles, 6 per triangle; not modified
     */
    VertexSplit(int count, GltfModel.Place place, float[] places) {
        this.count = count;
        corners = new int[place.vertices().length];
        coordinates = new float[2 * count];
        boolean[] known = new boolean[count];
        for (int i = 0; i < corners.length; i++) {
            int triangle = place.triangles()[i / 3];
            int vertex = place.vertices()[i];
            corners[i] = vertex;
            if (triangle >= 0) {
                int at = 6 * triangle + 2 * place.corner(i % 3);
                if (known[vertex] && (coordinates[2 * vertex] != places[at]
                        || coordinates[2 * vertex + 1] != places[at + 1])) {
                    corners[i] = further(vertex, places[at], places[at + 1]);
                } else {
                    known[vertex] = true;
                    coordinates[2 * vertex] = places[at];
                    coordinates[2 * vertex + 1] = places[at + 1];
                }
            }
        }
    }

    private int further(int vertex, float u, float v) {
        Integer known = more.get(new Key(vertex, u, v));
        if (known != null) {
            return known;
        }
        int number = count + more.size();
        more.put(new Key(vertex, u, v), number);
        if (number - count >= repeated.length) {
            repeated = Arrays.copyOf(repeated, 2 * repeated.length);
        }
        if (2 * number >= coordinates.length) {
            coordinates = Arrays.copyOf(coordinates, 2 * coordinates.length + 2);
        }
        repeated[number - count] = vertex;
        coordinates[2 * number] = u;
        coordinates[2 * number + 1] = v;
        return number;
    }

    /** The vertex that each vertex repeats. The primitive's own vertices come first, each as itself. */
    int[] rows() {
        int[] rows = new int[count + more.size()];
        for (int i = 0; i < rows.length; i++) {
            rows[i] = i < count ? i : repeated[i - count];
        }
        return rows;
    }

    /** u, v in the lightmap, 2 per vertex. */
    float[] coordinates() {
        return Arrays.copyOf(coordinates, 2 * (count + more.size()));
    }

    /** The vertices of the primitive's triangles, 3 per triangle. */
    int[] corners() {
        return corners;
    }
}
