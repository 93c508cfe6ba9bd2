package radiosity.testkit;

import java.util.Arrays;
import java.util.stream.IntStream;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/** A solution without a calculation: the front of each triangle is an element, and 1 W/m² arrives everywhere. */
public final class EvenLight {

    private EvenLight() { }

    public static Solution on(Scene scene) {
        double[] positions = new double[9 * scene.triangles()];
        for (int i = 0; i < 3 * scene.triangles(); i++) {
            Vec3 p = scene.corner(i / 3, i % 3);
            positions[3 * i] = p.x();
            positions[3 * i + 1] = p.y();
            positions[3 * i + 2] = p.z();
        }
        double[] irradiance = new double[positions.length];
        Arrays.fill(irradiance, 1);
        double[] none = new double[3];
        return new Solution(scene, 3, positions, irradiance, IntStream.range(0, 3 * scene.triangles()).toArray(),
                IntStream.range(0, scene.triangles()).map(t -> 2 * t).toArray(), 0, 0, 0,
                new EnergyLedger(none, none, none, none, none), SavedState.NONE);
    }
}
