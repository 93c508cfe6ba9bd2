package radiosity.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.World;

/**
 * Prints how long a stop that is asked for in mid-render waits at most: from one time that the listener is asked to the
 * next.
 *
 * <p>{@code scripts/longest-step <LightWave Scene> <seconds> [<patches> predict|paper]...}
 */
final class StepTable {

    private final ProgressiveRadiosity radiosity;
    private final double seconds;
    private long last;
    private double total;
    private int steps;
    private double longest;
    private Progress where;

    private StepTable(World world, double seconds) {
        this.seconds = seconds;
        radiosity = new ProgressiveRadiosity(world, new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT));
    }

    public static void main(String[] arguments) throws IOException {
        Scene scene = LightWaveReader.read(Path.of(arguments[0]), ReadOptions.defaults(), System.err::println);
        for (int i = 2; i < arguments.length; i += 2) {
            double patches = Double.parseDouble(arguments[i]);
            RadiositySettings settings = new RadiositySettings(patches == 0 ? 0 : scene.area() / patches, 0,
                    Double.POSITIVE_INFINITY, Schedule.valueOf(arguments[i + 1].toUpperCase(Locale.ROOT)));
            try (World world = new LocalWorld(scene, settings, Runtime.getRuntime().availableProcessors())) {
                System.out.printf("%s, %d patches: ", arguments[i + 1], world.patches());
                new StepTable(world, Double.parseDouble(arguments[1])).print();
            }
        }
    }

    private void print() throws IOException {
        last = System.nanoTime();
        radiosity.run(this::note);
        long end = System.nanoTime();
        Solution solution = radiosity.solution();
        System.out.printf(Locale.ROOT,
                "%d steps in %.1f s, the longest %.2f s (shot %d of round %d); %d elements merged"
                + " in %.2f s%n", steps, total, longest, where.shots(), where.rounds(), solution.elements(),
                (System.nanoTime() - end) * 1e-9);
    }

    private boolean note(Progress progress) {
        long now = System.nanoTime();
        double step = (now - last) * 1e-9;
        last = now;
        total += step;
        steps++;
        if (step > longest) {
            longest = step;
            where = progress;
        }
        return total < seconds;
    }
}
