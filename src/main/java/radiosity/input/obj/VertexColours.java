package radiosity.input.obj;

import radiosity.input.file.FloatList;
import radiosity.scene.Rgb;
import radiosity.scene.Srgb;

/** The colours that programs for scans write behind the coordinates of vertices: factors of the reflectance there. */
final class VertexColours {

    /** Largest value where colours are whole numbers of 8 bits; a value from {@link #BYTES} on says so for all. */
    private static final int WHITE_BYTE = 255;
    private static final int BYTES = 2;

    /** 3 per vertex up to the last one with a colour; NaN for a vertex without. */
    private final FloatList values = new FloatList();
    private float least = Float.POSITIVE_INFINITY;
    private float most;

    /**
     * Adds the colour of a vertex.
     *
     * @param vertex index of the vertex, larger than those before
     * @param colour the last three numbers are red, green and blue
     * @param size   count of numbers in {@code colour}, at least 3
     * @return whether the numbers are finite and at least 0; otherwise the vertex has no colour
     */
    boolean add(int vertex, double[] colour, int size) {
        for (int i = size - 3; i < size; i++) {
            if (!(colour[i] >= 0 && colour[i] <= Float.MAX_VALUE)) {
                return false;
            }
        }
        while (values.size() < 3 * vertex) {
            values.add(Float.NaN);
        }
        for (int i = size - 3; i < size; i++) {
            values.add((float) colour[i]);
            least = Math.min(least, (float) colour[i]);
            most = Math.max(most, (float) colour[i]);
        }
        return true;
    }

    /** Whether the file has no colours, or only white, which programs write that have none. */
    boolean isEmpty() {
        return values.size() == 0 || least == most && most == white();
    }

    private int white() {
        return most >= BYTES ? WHITE_BYTE : 1;
    }

    boolean has(int vertex) {
        return 3 * vertex < values.size() && !Float.isNaN(values.get(3 * vertex));
    }

    /**
     * The colour of a vertex that has one; 1 is white.
     *
     * @param srgb whether colours are sRGB and are made linear
     */
    Rgb of(int vertex, boolean srgb) {
        Rgb colour = new Rgb(values.get(3 * vertex), values.get(3 * vertex + 1), values.get(3 * vertex + 2))
                .times(1.0 / white());
        return srgb ? Srgb.linear(colour) : colour;
    }
}
