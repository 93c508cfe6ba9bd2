package radiosity.solution;

import java.util.List;
import radiosity.scene.Lamp;
import radiosity.scene.MaterialSample;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.util.NoNumberException;

/**
 * A world's elements and their light, merged from all partitions in the order of their ids.
 *
 * <p>Vertices are shared within a connected, coplanar part of a surface and nowhere else, so each has one normal. The
 * arrays are not modified after the solution is made.
 *
 * @param scene      the original triangles
 * @param channels   1 where everything in the scene is grey, else 3; times the number of layers
 * @param lamps      what has a layer of its own, in the order of the layers; empty where all light is in one
 * @param positions  x, y, z per vertex, scene units
 * @param irradiance H in W/m², {@code channels} per vertex
 * @param corners    vertices, 3 per element, counter-clockwise seen from its visible side
 * @param faceOf     1 per element: 2 * original triangle, + 1 for the back of a two-sided one
 * @param shots      patches that have shot
 * @param rounds     rounds in which they did
 * @param unshotFlux sum of |U| A over elements and channels, W
 * @param ledger     where the light went
 * @param state      what resuming needs; empty where it is not kept
 */
public record Solution(Scene scene, int channels, List<Lamp> lamps, double[] positions, double[] irradiance,
        int[] corners,
                       int[] faceOf, int shots, int rounds, double unshotFlux, EnergyLedger ledger, SavedState state) {

    /** What an irradiance or an exitance may be, W/m²: their sum fits into a float of the scene file. */
    public static final double LARGEST = Float.MAX_VALUE / 2;

    /** The door through which results leave: only numbers do. */
    public Solution {
        for (int i = 0; i < irradiance.length; i++) {
            if (!(Math.abs(irradiance[i]) <= LARGEST)) {
                int at = 3 * (i / channels);
                throw new NoNumberException("solution: expected an irradiance of at most " + (float) LARGEST
                        + " W/m2, got " + irradiance[i] + " at (" + positions[at] + ", " + positions[at + 1] + ", "
                        + positions[at + 2] + ")");
            }
        }
        NoNumberException.unlessNumbers("unshot flux", unshotFlux);
    }

    /** A solution in one layer. */
    public Solution(Scene scene, int channels, double[] positions, double[] irradiance, int[] corners, int[] faceOf,
                    int shots, int rounds, double unshotFlux, EnergyLedger ledger, SavedState state) {
        this(scene, channels, List.of(), positions, irradiance, corners, faceOf, shots, rounds, unshotFlux, ledger,
                state);
    }

    /** Number of elements. */
    public int elements() {
        return faceOf.length;
    }

    /** Number of vertices. */
    public int vertices() {
        return positions.length / 3;
    }

    /** The surface on which an element lies. */
    public Surface surface(int element) {
        return scene.surface(faceOf[element] >> 1);
    }

    /** At least 1. */
    public int layers() {
        return Math.max(1, lamps.size());
    }

    /** Irradiance H at a vertex, of all layers, W/m². */
    public Rgb irradianceAt(int vertex) {
        Rgb sum = irradianceAt(vertex, 0);
        for (int layer = 1; layer < layers(); layer++) {
            sum = sum.plus(irradianceAt(vertex, layer));
        }
        return sum;
    }

    /** Irradiance H at a vertex that is one lamp's, W/m². */
    public Rgb irradianceAt(int vertex, int layer) {
        int colours = channels / layers();
        int i = channels * vertex + colours * layer;
        return colours == 1 ? Rgb.grey(irradiance[i])
                : new Rgb(irradiance[i], irradiance[i + 1], irradiance[i + 2]);
    }

    /** Radiosity B = E + rho H (equation 1) at corner k of an element, W/m². */
    public Rgb radiosityAt(int element, int k) {
        return look(element).radiosity(irradianceAt(corners[3 * element + k]));
    }

    /** What there is to see of an element in the mean. */
    public MaterialSample look(int element) {
        int triangle = faceOf[element] >> 1;
        return scene.isMapped(triangle)
                ? scene.meanLook(triangle, corner(element, 0), corner(element, 1), corner(element, 2))
                : new MaterialSample(surface(element).exitance(), surface(element).reflectance());
    }

    private Vec3 corner(int element, int k) {
        int p = 3 * corners[3 * element + k];
        return new Vec3(positions[p], positions[p + 1], positions[p + 2]);
    }
}
