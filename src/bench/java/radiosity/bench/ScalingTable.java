package radiosity.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.master.RemoteWorld;
import radiosity.partition.BlockCosts;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.HostStatistics;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.World;
import radiosity.testkit.LogicalClock;

/**
 * Prints figures 11 to 13 of the paper, as scripts/reproduce-paper runs it.
 *
 * <p>All hosts are in this process, each with one thread, on a {@link LogicalClock}: the wall time is that of the
 * slowest host in every call, what the calls cost on a network, and the processor time of the master's thread, which
 * has a second one to help it. Speedup is over the mean of two calculations in one process, on one thread, just before
 * and just after: a busy machine is not always as busy. All is done some times before it is measured, as hosts serve
 * many renders, and then again: what is printed are medians.
 */
public final class ScalingTable {

    private static final double WARM_UP_SECONDS = 5;
    private static final int WARM_UPS = 3;
    private static final int TURNS = 5;
    /** Of the master. */
    private static final int THREADS = 2;

    private ScalingTable() { }

    /**
     * @param arguments file, patch area, rays, shots, meshing threshold or "off", schedule or what accuracy to predict
     *                  with, as in "0.5%"; then numbers of hosts
     */
    public static void main(String[] arguments) throws IOException {
        Scene scene = LightWaveReader.read(Path.of(arguments[0]), ReadOptions.defaults(), line -> { });
        RadiositySettings settings = settings(arguments);
        StopRule stop = new StopRule(Integer.parseInt(arguments[3]), StopRule.DEFAULT_UNSENT);
        warmUp(new LocalWorld(scene, settings, 1), stop);
        System.out.println("hosts  elements  alone s  calls   CPU s busiest s  idlest s  master s       MB   wall s  speedup  efficiency  worst idle %");
        for (int i = 6; i < arguments.length; i++) {
            int hosts = Integer.parseInt(arguments[i]);
            for (int t = 0; t < WARM_UPS; t++) {
                measure(scene, settings, stop, hosts);
            }
            print(scene, settings, stop, hosts);
        }
    }

    private static RadiositySettings settings(String[] arguments) {
        double meshing = arguments[4].equals("off") ? Double.POSITIVE_INFINITY : Double.parseDouble(arguments[4]);
        boolean isAccuracy = arguments[5].endsWith("%");
        Schedule schedule = isAccuracy ? Schedule.PREDICT : Schedule.valueOf(arguments[5].toUpperCase(Locale.ROOT));
        RadiositySettings settings = new RadiositySettings(Double.parseDouble(arguments[1]),
                Integer.parseInt(arguments[2]), meshing, schedule);
        return isAccuracy ? settings.accurate(Double.parseDouble(arguments[5].replace("%", "")) / 100) : settings;
    }

    /** Until the JVM has compiled what matters. */
    private static void warmUp(World world, StopRule stop) throws IOException {
        long end = System.nanoTime() + (long) (1e9 * WARM_UP_SECONDS);
        while (System.nanoTime() < end) {
            new ProgressiveRadiosity(world, stop).run(progress -> System.nanoTime() < end);
        }
    }

    private static RemoteWorld world(Scene scene, RadiositySettings settings, int hosts, LogicalClock clock)
            throws IOException {
        return new RemoteWorld(scene, settings, THREADS, System.err::println, clock.links(hosts), clock::now);
    }

    /** Processor time of one process on one thread, s. */
    private static double alone(Scene scene, RadiositySettings settings, StopRule stop) throws IOException {
        long begin = BlockCosts.now();
        new ProgressiveRadiosity(new LocalWorld(scene, settings, 1), stop).run(progress -> true);
        return (BlockCosts.now() - begin) * 1e-9;
    }

    /** The median of each column over some turns. */
    private static void print(Scene scene, RadiositySettings settings, StopRule stop, int hosts) throws IOException {
        double[][] turns = new double[TURNS][];
        double before = alone(scene, settings, stop);
        for (int t = 0; t < TURNS; t++) {
            turns[t] = measure(scene, settings, stop, hosts);
            double after = alone(scene, settings, stop);
            compare(turns[t], (before + after) / 2);
            before = after;
        }
        Object[] row = new Object[turns[0].length];
        Arrays.setAll(row, i -> Arrays.stream(turns).mapToDouble(turn -> turn[i]).sorted().toArray()[TURNS / 2]);
        System.out.printf(Locale.ROOT,
                "%5.0f %,9.0f %8.2f %6.0f %7.2f %9.3f %9.3f %9.3f %8.1f %8.3f %8.2f %11.3f %13.1f%n", row);
    }

    /** All but what one process takes. */
    private static double[] measure(Scene scene, RadiositySettings settings, StopRule stop, int hosts)
            throws IOException {
        LogicalClock clock = new LogicalClock();
        try (RemoteWorld world = world(scene, settings, hosts, clock)) {
            clock.reset();
            double begin = clock.seconds();
            new ProgressiveRadiosity(world, stop).run(progress -> true);
            double wall = clock.seconds() - begin;
            List<HostStatistics> all = world.statistics().hosts();
            double idle = all.stream().mapToDouble(HostStatistics::idle).max().orElse(0);
            double elements = all.stream().mapToInt(HostStatistics::elements).sum();
            return new double[] {hosts, elements, 0, clock.calls() / hosts, clock.cpu(), clock.busiest(),
                clock.idlest(), wall - clock.waited(), clock.bytes() / 1e6, wall, 0, 0, 100 * idle};
        }
    }

    /** @param alone processor time of one process, s */
    private static void compare(double[] turn, double alone) {
        turn[2] = alone;
        turn[10] = alone / turn[9];
        turn[11] = turn[10] / turn[0];
    }
}
