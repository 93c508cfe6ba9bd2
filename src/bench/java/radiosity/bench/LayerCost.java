package radiosity.bench;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import radiosity.accuracy.LayersTest;
import radiosity.scene.Rgb;
import radiosity.solution.Solution;
import radiosity.testkit.Solve;

/** What keeping the light of four lamps apart costs; docs/VIEWER.md has the command and figures. */
final class LayerCost {

    private static final int REPEATS = 3;

    private LayerCost() { }

    public static void main(String[] arguments) {
        for (int i = 0; i < REPEATS; i++) {
            for (boolean layered : new boolean[] {false, true}) {
                measure(layered);
            }
        }
    }

    private static void measure(boolean layered) {
        Solve solve = Solve.byDefault();
        OperatingSystemMXBean system = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        long before = system.getProcessCpuTime();
        Solution solution = solve.settings(solve.settings().layers(layered)).solution(LayersTest.room(Rgb.grey(1)));
        System.out.printf("%s: %.1f s of CPU time, %d elements, %d vertices, %d bytes of irradiance, %d bytes of state%n",
                layered ? "four layers" : "one layer", (system.getProcessCpuTime() - before) * 1e-9,
                        solution.elements(),
                solution.vertices(), 8L * solution.irradiance().length, solution.state().length());
    }
}
