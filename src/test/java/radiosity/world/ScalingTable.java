package radiosity.world;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import radiosity.lightwave.LightWaveOptions;
import radiosity.lightwave.LightWaveReader;
import radiosity.scene.Scene;

/**
 * Prints figures 11 to 13 of the paper, as scripts/reproduce-paper runs it.
 *
 * <p>All hosts are in this process, each with one thread, whose processor time is measured: that of the slowest host,
 * summed over rounds, is what the rounds would take on as many machines. To that comes what a round costs on a local
 * network, as it was measured between processes: 0.3 ms, two round trips of 0.2 ms, and 30 us of the master per host.
 */
public final class ScalingTable {

    private static final double CALL_SECONDS = 0.3e-3 + 2 * 0.2e-3;
    private static final double HOST_SECONDS = 30e-6;
    private static final int WARM_UP = 2;

    private ScalingTable() { }

    /** @param arguments file, patch area, rays, shots, meshing threshold or "off", schedule, then numbers of hosts */
    public static void main(String[] arguments) throws IOException {
        Scene scene = LightWaveReader.read(Path.of(arguments[0]), LightWaveOptions.defaults(), line -> { });
        double meshing = arguments[4].equals("off") ? Double.POSITIVE_INFINITY : Double.parseDouble(arguments[4]);
        RadiositySettings settings = new RadiositySettings(Double.parseDouble(arguments[1]),
                Integer.parseInt(arguments[2]), meshing, Schedule.valueOf(arguments[5].toUpperCase(Locale.ROOT)));
        StopRule stop = new StopRule(Integer.parseInt(arguments[3]), StopRule.DEFAULT_UNSENT);
        for (int i = 0; i < WARM_UP; i++) {
            solve(scene, settings, stop, 1);
        }
        System.out.println("hosts  elements  rounds   CPU s  slowest s  wall s  speedup  efficiency  worst idle %");
        double one = 0;
        for (int i = 6; i < arguments.length; i++) {
            int hosts = Integer.parseInt(arguments[i]);
            WorldStatistics statistics = solve(scene, settings, stop, hosts);
            double wall = statistics.criticalPath() + statistics.rounds() * (CALL_SECONDS + hosts * HOST_SECONDS);
            one = one == 0 ? wall * hosts : one;
            print(hosts, statistics, wall, one);
        }
    }

    private static WorldStatistics solve(Scene scene, RadiositySettings settings, StopRule stop, int hosts)
            throws IOException {
        try (RemoteWorld world = new RemoteWorld(scene, settings, 1, System.err::println, links(hosts))) {
            new ProgressiveRadiosity(world, stop).run(progress -> true);
            return world.statistics();
        }
    }

    /** Hosts that compute one after the other, so that none is slowed by the others. */
    private static List<Link> links(int hosts) {
        List<Link> links = TestLink.sound(hosts, 1);
        Object turn = new Object();
        for (Link link : links) {
            RemotePartition alone = ((TestLink) link).behind;
            ((TestLink) link).behind = (RemotePartition) Proxy.newProxyInstance(Link.class.getClassLoader(),
                    new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> {
                        if (!method.getName().equals("round")) {
                            return method.invoke(alone, arguments);
                        }
                        synchronized (turn) {
                            return method.invoke(alone, arguments);
                        }
                    });
        }
        return links;
    }

    private static void print(int hosts, WorldStatistics statistics, double wall, double one) {
        List<HostStatistics> all = statistics.hosts();
        double idle = all.stream().mapToDouble(HostStatistics::idle).max().orElse(0);
        int elements = all.stream().mapToInt(HostStatistics::elements).sum();
        System.out.printf(Locale.ROOT, "%5d %,9d %7d %7.2f %10.3f %7.3f %8.2f %11.3f %13.1f%n", hosts, elements,
                statistics.rounds(), statistics.cpu(), statistics.criticalPath(), wall, one / wall, one / wall / hosts,
                100 * idle);
    }
}
