package radiosity.distributed;

import java.io.IOException;
import java.net.ServerSocket;
import java.util.List;
import java.util.function.Consumer;
import radiosity.master.RemoteWorld;
import radiosity.rmi.HostAddress;
import radiosity.rmi.HostKey;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.World;
import radiosity.testkit.ColouredRoom;
import radiosity.worker.PartitionPort;

/** A coloured room that is solved in a second, here and there. */
final class Small {

    static final Scene SCENE = ColouredRoom.SCENE;
    static final StopRule STOP = new StopRule(80, 1e-3);

    private Small() { }

    /** Adaptive meshing is on in both. */
    static RadiositySettings settings(Schedule schedule) {
        double meshing = schedule == Schedule.PAPER ? 0.1 : Double.POSITIVE_INFINITY;
        return new RadiositySettings(SCENE.area() / 150, 0, meshing, schedule, 0.5, 8e-3);
    }

    static Solution local(Schedule schedule) throws IOException {
        return solve(new LocalWorld(SCENE, settings(schedule), 2));
    }

    static Solution remote(Schedule schedule, HostKey key, Consumer<String> notices, PartitionPort... hosts)
            throws IOException {
        List<HostAddress> addresses = List.of(hosts).stream().map(h -> new HostAddress("localhost", h.port())).toList();
        try (RemoteWorld world = new RemoteWorld(SCENE, settings(schedule), addresses, key, 1, notices)) {
            return solve(world);
        }
    }

    static Solution solve(World world) throws IOException {
        ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, STOP);
        rounds.run(progress -> true);
        return rounds.solution();
    }

    static PartitionPort serve(HostKey key, int threads) throws IOException {
        return PartitionPort.open(new PartitionPort.Options(freePort(), 0, null, key, threads), line -> { });
    }

    static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0)) {
            return socket.getLocalPort();
        }
    }
}
