package radiosity.solution;

import java.util.List;
import java.util.Objects;
import radiosity.scene.Lamp;
import radiosity.scene.MaterialSample;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.util.NoNumberException;

/**
 * The elements of a world and their light, merged from all blocks in the order of the blocks' ids.
 *
 * <p>Elements share vertices within a connected, coplanar part of a surface and nowhere else, so each vertex has one
 * normal. The arrays are kept, not copied; nobody may modify them.
 *
 * @param scene      the original scene
 * @param channels   1 where everything in the scene is grey, else 3; times the number of layers
 * @param lamps      the lamps with a layer each, in the order of the layers; empty where all light is in one layer
 * @param positions  3 per vertex: x, y, z, scene units
 * @param irradiance {@code channels} per vertex: irradiance H, W/m²
 * @param corners    3 per element: its vertices, counter-clockwise as seen from the visible side
 * @param faceOf     1 per element: 2 * original triangle, + 1 for the back of a two-sided triangle
 * @param shots      number of shots done
 * @param rounds     number of rounds done
 * @param unshotFlux sum of |U| A over elements and channels, W
 * @param ledger     balance of the light
 * @param state      state from which the calculation can go on; empty where none is kept
 */
public record Solution(Scene scene, int channels, List<Lamp> lamps, double[] positions, double[] irradiance,
        int[] corners,
                       int[] faceOf, int shots, int rounds, double unshotFlux, EnergyLedger ledger, SavedState state) {

    /** Largest irradiance or exitance, W/m²: the sum of two such numbers fits into a float of the scene file. */
    public static final double LARGEST = Float.MAX_VALUE / 2;

    /** @throws NoNumberException where an irradiance is NaN or above {@link #LARGEST}, or the flux not finite */
    public Solution {
        for (int i = 0; i < irradiance.length; i++) {
            if (!(Math.abs(irradiance[i]) <= LARGEST)) {
                int at = 3 * (i / channels);
                throw new NoNumberException("solution: expected an irradiance of at most " + (float) LARGEST
                        + " " + scene.units().irradiance() + ", got " + irradiance[i] + " at (" + positions[at] + ", "
                        + positions[at + 1] + ", " + positions[at + 2] + ")");
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

    /** Number of layers, at least 1. */
    public int layers() {
        return Math.max(1, lamps.size());
    }

    /** Irradiance H at a vertex, sum over all layers, W/m². */
    public Rgb irradianceAt(int vertex) {
        Rgb sum = irradianceAt(vertex, 0);
        for (int layer = 1; layer < layers(); layer++) {
            sum = sum.plus(irradianceAt(vertex, layer));
        }
        return sum;
    }

    /**
     * Irradiance H at a vertex in one layer, that is, from one lamp, W/m².
     *
     * @throws IndexOutOfBoundsException where there is no such vertex or layer
     */
    public Rgb irradianceAt(int vertex, int layer) {
        Objects.checkIndex(layer, layers());
        int colours = channels / layers();
        int i = channels * vertex + colours * layer;
        return colours == 1 ? Rgb.grey(irradiance[i])
                : new Rgb(irradiance[i], irradiance[i + 1], irradiance[i + 2]);
    }

    /**
     * Radiosity B = E + rho H (equation 1) at corner k of an element, W/m².
     *
     * @param k 0, 1 or 2
     * @throws IndexOutOfBoundsException where there is no such element or corner
     */
    public Rgb radiosityAt(int element, int k) {
        Objects.checkIndex(k, 3);
        return material(element).radiosity(irradianceAt(corners[3 * element + k]));
    }

    /** Mean exitance and reflectance over an element. */
    public MaterialSample material(int element) {
        int triangle = faceOf[element] >> 1;
        return scene.isMapped(triangle)
                ? scene.meanMaterial(triangle, corner(element, 0), corner(element, 1), corner(element, 2))
                : new MaterialSample(surface(element).exitance(), surface(element).reflectance());
    }

    private Vec3 corner(int element, int k) {
        int p = 3 * corners[3 * element + k];
        return new Vec3(positions[p], positions[p + 1], positions[p + 2]);
    }
}
