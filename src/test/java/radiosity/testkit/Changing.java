package radiosity.testkit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Optional;
import java.util.stream.DoubleStream;
import radiosity.edit.LightDifference;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.World;

/**
 * Solutions that are changed with their scenes, and that these are, within the error that was asked for, those of
 * renders anew: the root mean square difference of two solutions that each are off by an error is at most the sum of
 * both.
 *
 * @param error    that is asked for
 * @param settings with that
 */
public record Changing(double error, RadiositySettings settings) {

    public static final StopRule STOP = new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT);

    public Changing(double error) {
        this(error, RadiositySettings.defaults().accurate(error));
    }

    public Solution anew(Scene scene) {
        try (LocalWorld world = new LocalWorld(scene, settings, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            radiosity.run(progress -> true);
            return radiosity.solution();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    public Solution changed(Scene scene, SavedState from) throws IOException {
        return changed(new LocalWorld(scene, settings, 2), from);
    }

    public Solution changed(World ofScene, SavedState from) throws IOException {
        try (World world = ofScene) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            assertEquals(Optional.empty(), radiosity.change(from));
            radiosity.run(progress -> true);
            return radiosity.solution();
        }
    }

    /** Why a scene is rendered anew. */
    public String obstacle(Scene scene, SavedState from) throws IOException {
        try (LocalWorld world = new LocalWorld(scene, settings, 2)) {
            return new ProgressiveRadiosity(world, STOP).change(from).orElseThrow();
        }
    }

    /**
     * In every layer for itself; and no energy is gained where as much is emitted: light that enters an open scene is
     * counted on the elements that it meets.
     */
    public void assertAsAnew(Scene scene, SavedState from) throws IOException {
        Solution anew = anew(scene);
        Solution changed = changed(scene, from);
        assertAlike(anew, changed);
        double least = DoubleStream.of(changed.irradiance()).min().orElseThrow();
        assertTrue(least >= -1e-6 * DoubleStream.of(changed.irradiance()).average().orElseThrow(), "least " + least);
        EnergyLedger ledger = changed.ledger();
        for (int c = 0; c < ledger.emitted().length; c++) {
            assertEquals(0, ledger.imbalance(c), 1e-12);
            double gained = ledger.deficit(c) - anew.ledger().deficit(c);
            assertTrue(ledger.emitted()[c] != anew.ledger().emitted()[c]
                    || Math.abs(gained) < 0.1 * error * ledger.emitted()[c], "gains " + gained);
        }
    }

    public void assertAlike(Solution expected, Solution got) {
        for (int layer = 0; layer < expected.layers(); layer++) {
            double difference = difference(ofLayer(expected, layer), ofLayer(got, layer));
            assertTrue(difference < 2 * error, "difference " + difference + " in layer " + layer);
        }
    }

    /** Root mean square, of the mean. */
    private static double difference(Solution expected, Solution got) {
        double[] places = LightDifference.places(expected.scene(), 4000);
        double[] a = Evaluate.radiosity(expected, places);
        double[] b = Evaluate.radiosity(got, places);
        double sum = 0;
        double squares = 0;
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            if (!Double.isNaN(a[i]) && !Double.isNaN(b[i])) {
                sum += a[i];
                squares += (a[i] - b[i]) * (a[i] - b[i]);
                count++;
            }
        }
        return Math.sqrt(squares / count) / (sum / count);
    }

    /** The light of one lamp, as if there were no other. */
    private static Solution ofLayer(Solution of, int layer) {
        if (of.layers() == 1) {
            return of;
        }
        double[] irradiance = new double[3 * of.vertices()];
        for (int i = 0; i < irradiance.length; i++) {
            irradiance[i] = of.irradianceAt(i / 3, layer).channel(i % 3);
        }
        return new Solution(of.scene(), 3, of.positions(), irradiance, of.corners(), of.faceOf(), 0, 0, 0,
                of.ledger(), SavedState.NONE);
    }
}
