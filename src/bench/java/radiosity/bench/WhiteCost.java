package radiosity.bench;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/** Prints what rooms of different reflectances cost to solve, relative to .5: {@code scripts/extremes cost}. */
final class WhiteCost {

    private static final double[] REFLECTANCES = {.5, .9, .99, .999};
    private static final int TURNS = 3;

    private WhiteCost() { }

    /** The least of a few turns on one thread; reflectances take turns, so that all see the same machine. */
    static void print() {
        System.out.println("| room with two blocks and a lamp, reflectance | CPU s | of that at .5 |\n|---|---|---|");
        double[] least = new double[REFLECTANCES.length];
        Arrays.fill(least, Double.POSITIVE_INFINITY);
        for (int turn = 0; turn <= TURNS; turn++) {
            for (int i = 0; i < least.length; i++) {
                double taken = seconds(room(REFLECTANCES[i]));
                least[i] = turn == 0 ? least[i] : Math.min(least[i], taken);
            }
        }
        for (int i = 0; i < least.length; i++) {
            System.out.printf(Locale.ROOT, "| %s | %.2f | %.2f |%n", REFLECTANCES[i], least[i], least[i] / least[0]);
        }
    }

    private static Scene room(double reflectance) {
        Surface wall = RoomScenes.grey("wall", 0, reflectance);
        return RoomScenes.withBlocks(wall, RoomScenes.grey("lamp", 1, reflectance));
    }

    private static double seconds(Scene room) {
        double before = cpuSeconds();
        Solve.byDefault().threads(1).solution(room);
        return cpuSeconds() - before;
    }

    private static double cpuSeconds() {
        var bean = (com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        return bean.getProcessCpuTime() * 1e-9;
    }
}
