package radiosity.bench;

import java.io.DataInputStream;
import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.UnicastRemoteObject;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import radiosity.protocol.Answer;
import radiosity.protocol.BlockWork;
import radiosity.protocol.Order;
import radiosity.protocol.Reply;
import radiosity.protocol.SceneBytes;
import radiosity.protocol.Wire;
import radiosity.rmi.RemotePartition;
import radiosity.rmi.SerialFilters;
import radiosity.setup.InitialMesh;
import radiosity.util.Pieces;
import radiosity.worker.PartitionPort;
import radiosity.worker.ServedPartition;

/**
 * A host that sleeps instead of computing: many of them on one machine do not disturb each other, and what a round
 * takes beyond the sleep is what distribution costs.
 */
final class IdealHost {

    /** What a round takes on every host. */
    static final double SECONDS = 0.05;
    /** In so many rounds all candidates are named. */
    private static final int TURNS = 4;

    private final RemotePartition real = new ServedPartition(1, line -> { });
    private InitialMesh mesh;
    private Reply first;
    /** The number of the last round; one is done after another. */
    private long done;

    private IdealHost() { }

    /** @param arguments -port and its number */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        int port = Integer.parseInt(arguments[1]);
        IdealHost host = new IdealHost();
        Registry registry = LocateRegistry.createRegistry(port);
        InvocationHandler handler = (proxy, method, values) -> {
            if (method.getName().equals("round")) {
                return host.round((long) values[0], (long) values[1], (byte[][]) values[2]);
            }
            if (method.getName().equals("send") && host.mesh == null) {
                SceneBytes.Task task = SceneBytes.read(Wire.input((byte[]) values[1]));
                host.mesh = new InitialMesh(task.scene(), task.settings());
            }
            try {
                return method.invoke(host.real, values);
            } catch (InvocationTargetException e) {
                throw e.getCause();
            }
        };
        RemotePartition partition = (RemotePartition) Proxy.newProxyInstance(IdealHost.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, handler);
        Remote stub = UnicastRemoteObject.exportObject(partition, port, null, null, SerialFilters::ofHost);
        registry.rebind(PartitionPort.NAME, (Remote) Proxy.getInvocationHandler(stub));
        System.out.println("listening on port " + port);
        Thread.currentThread().join();
    }

    /** The first question is answered truly; candidates of that answer serve in turn for all rounds. */
    private synchronized byte[] round(long session, long number, byte[][] pieces)
            throws IOException, InterruptedException {
        while (number > done + 1) {
            wait();
        }
        done = number;
        notifyAll();
        Order order = Order.decode(new DataInputStream(Pieces.open(List.of(pieces))));
        if (first == null) {
            byte[] answer = real.round(session, number, pieces);
            first = Reply.decode(answer);
            return answer;
        }
        double seconds = seconds(order);
        long end = System.nanoTime() + (long) (seconds * 1e9);
        Answer answer = new Answer(mesh.faces, mesh.fluxScale());
        answer.read(Wire.input(first.answer()));
        int all = answer.candidates.size();
        Collections.rotate(answer.candidates, (int) (number % TURNS) * all / TURNS);
        answer.candidates.subList(Math.max(0, Math.min(order.most(), all / TURNS)), all).clear();
        byte[] reply = new Reply(Wire.bytes(answer::write), seconds, seconds, first.work().stream()
                .map(IdealHost::done).toList(), new byte[0])
                .encode();
        for (long left = end - System.nanoTime(); left > 0; left = end - System.nanoTime()) {
            LockSupport.parkNanos(left);
        }
        return reply;
    }

    /** A round may be done in two parts, and a question follows it. */
    private static double seconds(Order order) {
        boolean isPart = order.givesGhosts() || order.kind() == Order.Kind.REST;
        return order.kind() == Order.Kind.ASK ? 0 : isPart ? SECONDS / 2 : SECONDS;
    }

    private static BlockWork done(BlockWork block) {
        return new BlockWork(block.elements(), block.points(), block.points(), block.points() * 1e-6f);
    }
}
