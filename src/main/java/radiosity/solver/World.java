package radiosity.solver;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.protocol.Wire;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;

/**
 * Everything in a scene, wherever its elements are (section 4.5.1 of the paper).
 *
 * <p>A world updates its elements for the shots it is given; which shots, and until when, is decided by
 * {@link ProgressiveRadiosity}.
 */
public abstract class World implements AutoCloseable {

    public final InitialMesh mesh;
    /** For what is not done by partitions. */
    public final ParallelFor parallel;

    /**
     * @param threads of this process, at least 1
     * @throws IllegalArgumentException where the number of threads is below 1
     */
    public World(Scene scene, RadiositySettings settings, int threads) {
        parallel = new ParallelFor(threads);
        mesh = new InitialMesh(scene, settings);
    }

    public Scene scene() {
        return mesh.scene;
    }

    public RadiositySettings settings() {
        return mesh.settings;
    }

    /** Largest area of a patch of the initial mesh, square scene units: as asked, or as chosen from the scene. */
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

    /** 1 where everything in the scene is grey, else 3; times the number of layers. */
    public int channels() {
        return mesh.faces.channels();
    }

    /** One round on all partitions: what each of them answers, as bytes. */
    public abstract List<byte[]> round(Order order) throws IOException;

    /** One round on all partitions where each says how things stand then. */
    List<Answer> answers(Order order) throws IOException {
        return decode(round(order));
    }

    /** Asks for rows, see {@link Order.Kind#ROWS}, and has them taken. */
    public void rows(Order order, Planner planner) throws IOException {
        planner.take(order.shots().size(), round(order));
    }

    /** Receives how long a step took. */
    public interface StepTimes {
        void took(int shots, double seconds);
    }

    /** Ignores them. */
    public static final StepTimes NOBODY = (shots, seconds) -> { };

    /** What partitions answer to an order that was begun. Nobody else has it than the caller who began the order. */
    public interface Begun {

        /**
         * Waits for the answers of all partitions; not for orders that are not {@linkplain Order#isAnswered answered}.
         *
         * @param times receives every step that is done by now
         * @return the answers added up
         */
        Answer answer(StepTimes times) throws IOException;
    }

    /**
     * Begins an order, or a step of a round, that may still be under way afterwards, and others with it.
     *
     * @param times receives every step that is done by now
     */
    public abstract Begun begin(Order step, StepTimes times) throws IOException;

    /** Waits until no order is under way. */
    public abstract void finish(StepTimes times) throws IOException;

    /** How many steps may be under way, at least 1. */
    public abstract int stepsAhead();

    /** A clock for differences, ns. */
    public abstract long now();

    /** One round on all partitions: their answers added up. */
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

    /** What all shooters have ever shot. */
    public List<Shot> totals() throws IOException {
        List<Shot> totals = new ArrayList<>();
        for (byte[] bytes : round(Order.asking(Order.Kind.TOTALS, 0))) {
            totals.addAll(Wire.shots(Wire.input(bytes)));
        }
        return joined(totals);
    }

    /** What all shooters have not shot yet, but for rounding; see {@link Order.Kind#UNSHOT}. */
    public final List<Shot> unshot() throws IOException {
        List<Shot> unshot = new ArrayList<>();
        for (byte[] bytes : round(Order.asking(Order.Kind.UNSHOT, 0))) {
            unshot.addAll(Wire.shots(Wire.input(bytes)));
        }
        return joined(unshot);
    }

    /** Those of blocks as those of what shoots together; sorted. */
    public final List<Shot> joined(List<Shot> shots) {
        return mesh.shootsClusters() ? mesh.clusters.join(shots, parallel) : shots.stream().sorted().toList();
    }

    /** The states of all blocks, by id. */
    public abstract List<byte[]> blocks() throws IOException;

    /** Puts all blocks back to what {@link #blocks} had given. */
    public abstract void restore(List<byte[]> states) throws IOException;

    @Override
    public void close() { }
}
