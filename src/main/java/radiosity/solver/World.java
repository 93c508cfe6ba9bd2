package radiosity.solver;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.room.DarkCavities;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Partitions;
import radiosity.protocol.Shot;
import radiosity.protocol.Wire;
import radiosity.scene.Lamp;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;

/**
 * Everything in a scene, wherever its elements are (section 4.5.1 of the paper).
 *
 * <p>A world updates its elements for the shots it is given; which shots, and until when, is decided by
 * {@link ProgressiveRadiosity}.
 */
public abstract class World implements Partitions, AutoCloseable {

    public final InitialMesh mesh;
    /** Threads of this process, for work that partitions do not do. */
    public final ParallelFor parallel;

    /**
     * @param threads of this process, at least 1
     * @throws IllegalArgumentException where the number of threads is below 1
     */
    public World(Scene scene, RadiositySettings settings, int threads) {
        parallel = new ParallelFor(threads);
        mesh = new InitialMesh(scene, settings);
    }

    public RadiositySettings settings() {
        return mesh.settings;
    }

    /** Largest area of a patch of the initial mesh, square scene units: given by the user or chosen for the scene. */
    public double patchArea() {
        return mesh.patchArea();
    }

    /** Number of patches of the initial mesh. */
    public long patches() {
        return mesh.patcher.patches();
    }

    /** Triangles of the scene that are too small to radiate; they still occlude. */
    public int droppedTriangles() {
        return mesh.faces.dropped();
    }

    /** The closed bodies that are {@linkplain DarkCavities#insideOut inside out}: the surfaces of each. */
    public List<List<Surface>> insideOut() {
        return DarkCavities.insideOut(mesh.faces).stream().map(body -> IntStream.of(body)
                .mapToObj(f -> mesh.scene.surface(mesh.faces.triangle(f))).distinct().toList()).toList();
    }

    /** The lamps whose light arrives nowhere, found by rays. */
    public List<Lamp> unseenLamps() {
        return mesh.unseenLamps();
    }

    /** 1 where everything in the scene is grey, else 3; times the number of layers. */
    public int channels() {
        return mesh.faces.channels();
    }

    /** Carries out an order on all partitions and returns the encoded answer of each. */
    public abstract List<byte[]> round(Order order) throws IOException;

    /** Carries out an order on all partitions and returns the answer of each. */
    List<Answer> answers(Order order) throws IOException {
        return decode(round(order));
    }

    /** Carries out an order for rows of the coarse system, see {@link Order.Kind#ROWS}, and gives them to a planner. */
    public void rows(Order order, Planner planner) throws IOException {
        planner.take(order.shots().size(), round(order));
    }

    /** Receives the number of shots and the duration of steps. */
    public interface StepTimes {
        void took(int shots, double seconds);
    }

    /** Ignores the durations of steps. */
    public static final StepTimes IGNORE_TIMES = (shots, seconds) -> { };

    /** The pending answers of all partitions to an order; read by the caller who began the order alone. */
    public interface Begun {

        /**
         * Waits for the answers of all partitions. Not allowed where the order is not {@linkplain Order#isAnswered
         * answered}.
         *
         * @param times receives the duration of every step that has ended
         * @return the sum of the answers
         */
        Answer answer(StepTimes times) throws IOException;
    }

    /**
     * Begins an order, or a step of a round. The method may return before the order is carried out; up to
     * {@link #stepsAhead} orders are under way at a time.
     *
     * @param times receives the duration of every step that has ended
     */
    public abstract Begun begin(Order step, StepTimes times) throws IOException;

    /** Waits until all orders are carried out. */
    public abstract void finish(StepTimes times) throws IOException;

    /** Largest number of steps under way, at least 1. */
    public abstract int stepsAhead();

    /** Time from an arbitrary origin, ns. */
    public abstract long now();

    /** Carries out an order on all partitions and returns the sum of their answers. */
    public final Answer answer(Order order) throws IOException {
        return sum(answers(order), order.most());
    }

    public final List<Answer> decode(List<byte[]> encoded) throws IOException {
        Answer[] answers = new Answer[encoded.size()];
        try {
            parallel.run(answers.length, i -> answers[i] = decode(encoded.get(i)));
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        return List.of(answers);
    }

    private Answer decode(byte[] bytes) {
        Answer answer = new Answer(mesh.faces, mesh.fluxScale());
        try {
            answer.read(Wire.input(bytes));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return answer;
    }

    public final Answer sum(List<Answer> answers, int most) {
        Answer all = new Answer(mesh.faces, mesh.fluxScale());
        all.add(answers, most);
        return all;
    }

    /** Total radiosity that every shooter has shot. */
    public List<Shot> totals() throws IOException {
        return shots(Order.Kind.TOTALS);
    }

    /** Unshot radiosity of every shooter, without rounding errors; see {@link Order.Kind#UNSHOT}. */
    public final List<Shot> unshot() throws IOException {
        return shots(Order.Kind.UNSHOT);
    }

    private List<Shot> shots(Order.Kind kind) throws IOException {
        List<Shot> all = new ArrayList<>();
        for (byte[] bytes : round(Order.asking(kind, 0))) {
            all.addAll(Wire.shots(Wire.input(bytes)));
        }
        return joined(all);
    }

    /** Joins the shots of patches that shoot as one cluster, and sorts them. */
    public final List<Shot> joined(List<Shot> shots) {
        return mesh.shootsClusters() ? mesh.clusters.join(shots, parallel) : shots.stream().sorted().toList();
    }

    /** The encoded states of all blocks, one per block, by block id. */
    public abstract List<byte[]> blocks() throws IOException;

    /** Sets all blocks to states that {@link #blocks} has returned. */
    public abstract void restore(List<byte[]> states) throws IOException;

    @Override
    public void close() { }
}
