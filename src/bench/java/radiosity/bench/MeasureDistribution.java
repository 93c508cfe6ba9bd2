package radiosity.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.FutureTask;
import java.util.stream.Stream;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.master.RemoteWorld;
import radiosity.master.host.Link;
import radiosity.partition.BlockCosts;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.rmi.HostAddress;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.StepSizer;
import radiosity.solver.World;
import radiosity.testkit.LogicalClock;
import radiosity.testkit.TestLink;
import radiosity.worker.PartitionPort;

/** What distribution costs, as scripts/measure-distribution prints it. */
public final class MeasureDistribution {

    private static final String SERVER = "radiosity.cli.PartitionServer";
    private static final int REPETITIONS = 3;
    /** Renders until JVMs have compiled what matters. */
    private static final int WARM = 3;
    private static final int TURNS = 5;
    /** A step of who has half a processor, by the clock, s. */
    private static final double HALF_STEP = 2 * StepSizer.STEP_SECONDS;

    private final Scene scene;

    private MeasureDistribution(Scene scene) {
        this.scene = scene;
    }

    /** @param arguments what to measure, and a scene */
    public static void main(String[] arguments) throws Exception {
        MeasureDistribution measure = new MeasureDistribution(LightWaveReader.read(Path.of(arguments[1]),
                ReadOptions.defaults(), line -> { }));
        switch (arguments[0]) {
            case "lost" -> measure.lost();
            case "slow" -> measure.slow();
            case "ideal" -> measure.ideal();
            case "loopback" -> measure.loopback();
            case "real" -> measure.real();
            case "start" -> measure.start();
            default -> throw new IllegalArgumentException("expected lost, slow, ideal, loopback, real or start, got "
                    + arguments[0]);
        }
        System.exit(0);
    }

    private static RadiositySettings paper(double patchArea, int rays) {
        return new RadiositySettings(patchArea, rays, Double.POSITIVE_INFINITY, Schedule.PAPER);
    }

    /** Processor time of one process on one thread, s. */
    private double alone(RadiositySettings settings, StopRule stop) throws IOException {
        return spent(new LocalWorld(scene, settings, 1), stop);
    }

    private static void print(String format, Object... values) {
        System.out.printf(Locale.ROOT, format + "%n", values);
    }

    /*---- Hosts in this process, on a logical clock ----*/

    /** What all hosts compute more where one of four is killed half way. */
    private void lost() throws IOException {
        RadiositySettings settings = paper(1000, 10);
        StopRule stop = new StopRule(4000, 0);
        four(settings, stop, Integer.MAX_VALUE);
        double without = 0;
        double with = 0;
        for (int i = 0; i < REPETITIONS; i++) {
            LogicalClock sound = four(settings, stop, Integer.MAX_VALUE);
            LogicalClock killed = four(settings, stop, sound.calls() / 8);
            without += sound.cpu();
            with += killed.cpu();
        }
        print("processor time of all hosts: %.2f s; one of four killed half way: %.2f s, %.1f %% more",
                without / REPETITIONS, with / REPETITIONS, 100 * (with / without - 1));
    }

    private LogicalClock four(RadiositySettings settings, StopRule stop, int death) throws IOException {
        LogicalClock clock = new LogicalClock();
        List<Link> links = new ArrayList<>(clock.links(3));
        links.add(clock.link(new TestLink("igge", 1, round -> round == death), 1));
        try (RemoteWorld world = world(settings, links, clock)) {
            new ProgressiveRadiosity(world, stop).run(progress -> true);
        }
        return clock;
    }

    private RemoteWorld world(RadiositySettings settings, List<Link> links, LogicalClock clock) throws IOException {
        return new RemoteWorld(scene, settings, 1, line -> print("  %s", line), links, clock::now);
    }

    /** Three hosts like this machine, and one that is four times slower. */
    private void slow() throws IOException {
        RadiositySettings settings = paper(200, 10);
        StopRule stop = new StopRule(5000, 0);
        four(settings, new StopRule(2000, 0), Integer.MAX_VALUE);
        double local = alone(settings, stop);
        LogicalClock clock = new LogicalClock();
        List<Link> links = new ArrayList<>(clock.links(3));
        links.add(clock.link(new TestLink("slow", 1, round -> false), 4));
        try (RemoteWorld world = world(settings, links, clock)) {
            clock.reset();
            double begin = clock.seconds();
            new ProgressiveRadiosity(world, stop).run(progress -> true);
            double wall = clock.seconds() - begin;
            print("one process %.2f s; four hosts of speeds 1, 1, 1, 0.25 %.2f s: %.3f of the summed speed; busiest %.2f s",
                    local, wall, local / wall / 3.25, clock.busiest());
        }
    }

    /*---- Processes ----*/

    /**
     * Hosts that sleep: what a round takes beyond that. As many rounds are under way when the clock is started as when
     * it is stopped.
     */
    private void ideal() throws IOException {
        int rounds = 100;
        for (int n : new int[] {1, 2, 4, 8, 16}) {
            List<HostProcess> hosts = HostProcess.start(n, IdealHost.class.getName(), "-Xmx64m", "-XX:+UseSerialGC",
                    "-XX:TieredStopAtLevel=1");
            try (RemoteWorld world = world(hosts, paper(1000, 1))) {
                List<Long> times = new ArrayList<>();
                new ProgressiveRadiosity(world, new StopRule(Integer.MAX_VALUE, 0)).run(progress -> {
                    times.add(System.nanoTime());
                    return times.size() <= 2 * rounds;
                });
                double seconds = (times.get(2 * rounds) - times.get(rounds)) * 1e-9 / rounds;
                print("%2d hosts that sleep %.0f ms a round: %.2f ms, efficiency %.3f", n, 1e3 * IdealHost.SECONDS,
                        1e3 * seconds, IdealHost.SECONDS / seconds);
            } finally {
                HostProcess.end(hosts);
            }
        }
    }

    private RemoteWorld world(List<HostProcess> hosts, RadiositySettings settings) throws IOException {
        return new RemoteWorld(scene, settings, hosts.stream().map(HostProcess::address).toList(), null, 1,
                line -> print("  %s", line));
    }

    /**
     * A host over sockets and no host at the same time, on one processor, which the script sees to: what is done in
     * turns differs by more than is to be measured, as the machine is not as fast from one second to the next. All that
     * this process does beside the thread that has no host counts for the one that has: master, host, both ends of the
     * sockets, collecting garbage and compiling.
     */
    private void loopback() throws Exception {
        int number = HostProcess.freePort();
        List<Double> more = new ArrayList<>();
        try (PartitionPort port = PartitionPort.open(new PartitionPort.Options(number, 0, null, null, 1),
                line -> { })) {
            for (int i = 0; i < WARM + TURNS; i++) {
                double[] seconds = sideBySide(new HostAddress("localhost", port.port()));
                if (i >= WARM) {
                    more.add(100 * (seconds[1] / seconds[0] - 1));
                    print("no host: CPU %.3f s; at the same time one host and its master, over sockets: CPU %.3f s, %+.1f %%",
                            seconds[0], seconds[1], more.get(more.size() - 1));
                }
            }
        }
        print("one host over sockets: %+.1f %% in the middle of %d turns", median(more), TURNS);
    }

    /** Processor time without a host and with one, s. */
    private double[] sideBySide(HostAddress address) throws Exception {
        RadiositySettings settings = paper(300, 10);
        StopRule stop = new StopRule(3000, 0);
        LocalWorld local = new LocalWorld(scene, settings, 1);
        try (RemoteWorld remote = new RemoteWorld(scene, settings, List.of(address), null, 1,
                line -> print("  %s", line))) {
            double begin = cpu();
            FutureTask<Double> without = new FutureTask<>(() -> spent(local, stop, HALF_STEP));
            new Thread(without).start();
            spent(remote, stop, HALF_STEP);
            double alone = without.get();
            return new double[] {alone, cpu() - begin - alone};
        }
    }

    /** Of this thread, s. */
    private static double spent(World world, StopRule stop) throws IOException {
        return spent(world, stop, StepSizer.STEP_SECONDS);
    }

    private static double spent(World world, StopRule stop, double stepSeconds) throws IOException {
        long begin = BlockCosts.now();
        new ProgressiveRadiosity(world, stop, stepSeconds).run(progress -> true);
        return (BlockCosts.now() - begin) * 1e-9;
    }

    private static double median(List<Double> values) {
        return values.stream().sorted().toList().get(values.size() / 2);
    }

    /**
     * One host and two others, in turns once their JVMs are warm: the machine's speed differs by a third from one
     * minute to the next, so that only what is measured side by side may be compared.
     */
    private void real() throws IOException {
        List<HostProcess> one = HostProcess.start(1, SERVER, "-Xmx512m", "-XX:+UseParallelGC");
        List<HostProcess> two = HostProcess.start(2, SERVER, "-Xmx512m", "-XX:+UseParallelGC");
        List<Double> speedups = new ArrayList<>();
        for (int i = 0; i < WARM + TURNS; i++) {
            double[] alone = hosted(one);
            double[] both = hosted(two);
            if (i >= WARM) {
                speedups.add(alone[0] / both[0]);
                print("one host: wall %.2f s, CPU %.2f s; two: wall %.2f s, CPU %.2f s; of it the master %.2f and %.2f s;"
                        + " speedup %.2f", alone[0], alone[1], both[0], both[1], alone[2], both[2], alone[0] / both[0]);
            }
        }
        HostProcess.end(one);
        HostProcess.end(two);
        print("speedup of two hosts over one: %.2f in the middle of %d turns", median(speedups), TURNS);
    }

    private double[] hosted(List<HostProcess> hosts) throws IOException {
        try (RemoteWorld world = world(hosts, paper(300, 10))) {
            return timed(world, new StopRule(3000, 0), hosts);
        }
    }

    /** Wall time, processor time of all, and of it the master's; s. */
    private static double[] timed(World world, StopRule stop, List<HostProcess> hosts) throws IOException {
        long begin = System.nanoTime();
        double mine = cpu();
        double there = hosts.stream().mapToDouble(HostProcess::cpu).sum();
        new ProgressiveRadiosity(world, stop).run(progress -> true);
        double master = cpu() - mine;
        return new double[] {(System.nanoTime() - begin) * 1e-9,
            master + hosts.stream().mapToDouble(HostProcess::cpu).sum() - there, master};
    }

    /** Of this process, s. */
    private static double cpu() {
        return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
                .getProcessCpuTime() * 1e-9;
    }

    /** Three million elements: until the first round may begin, and what a host keeps. */
    private void start() throws IOException {
        RadiositySettings settings = new RadiositySettings(scene.area() / 1.3e6, 1, Double.POSITIVE_INFINITY,
                Schedule.PAPER);
        for (int n : new int[] {1, 2, 4}) {
            List<HostProcess> hosts = HostProcess.start(n, SERVER, "-Xmx2g");
            long begin = System.nanoTime();
            try (RemoteWorld world = world(hosts, settings)) {
                Answer answer = world.answer(Order.asking(Order.Kind.ASK, 1));
                double seconds = (System.nanoTime() - begin) * 1e-9;
                List<String> memory = new ArrayList<>();
                for (HostProcess host : hosts) {
                    memory.add(live(host) + " MiB");
                }
                print("%,d elements, %d host(s): ready after %.1f s; live memory %s", answer.elements, n, seconds,
                        memory);
            } finally {
                HostProcess.end(hosts);
            }
        }
    }

    /** What a collection leaves in a host's heap, MiB. */
    private static long live(HostProcess host) throws IOException {
        Process histogram = new ProcessBuilder("jcmd", "" + host.id(), "GC.class_histogram").start();
        String text = new String(histogram.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        String total = Stream.of(text.split("\n")).filter(line -> line.startsWith("Total")).findFirst().orElseThrow();
        return Long.parseLong(total.trim().split("\\s+")[2]) >> 20;
    }
}
