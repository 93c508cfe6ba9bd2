package radiosity.world;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import radiosity.scene.Scene;

/**
 * Everything in a scene, wherever its elements are (section 4.5.1 of the paper).
 *
 * <p>A world updates its elements for the shots it is given; which shots, and until when, is decided by
 * {@link ProgressiveRadiosity}.
 */
public abstract sealed class World implements AutoCloseable permits LocalWorld, RemoteWorld {

    final InitialMesh mesh;

    World(InitialMesh mesh) {
        this.mesh = mesh;
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

    /** One round on all partitions: what each of them answers. */
    abstract List<byte[]> round(Order order) throws IOException;

    /** Told how long a step took. */
    interface StepTimes {
        void took(int shots, double seconds);
    }

    /**
     * A step of a round whose answer nobody reads. It may still be under way afterwards, and others with it: what is
     * asked for later waits for them.
     *
     * @param times told about every step that is done by now
     */
    abstract void begin(Order step, StepTimes times) throws IOException;

    /** Waits for what is under way. */
    abstract void finish(StepTimes times) throws IOException;

    /** How many steps may be under way, at least 1. */
    abstract int stepsAhead();

    /** A clock for differences, ns. */
    abstract long now();

    /** How many candidates each partition names so that together they most probably name the best so many. */
    int named(int most) {
        return most;
    }

    /** One round on all partitions: their answers added up. */
    final Answer answer(Order order) throws IOException {
        int most = order.most();
        List<Answer> some = answers(order.naming(named(most)));
        Answer all = sum(some, most);
        boolean complete = some.stream().allMatch(one -> one.namesAllOf(all, named(most), most));
        return complete ? all : sum(answers(Order.plain(Order.Kind.ASK, most)), most);
    }

    private List<Answer> answers(Order order) throws IOException {
        List<Answer> answers = new ArrayList<>();
        for (byte[] bytes : round(order)) {
            Answer one = new Answer(mesh.faces, mesh.fluxScale());
            one.read(Wire.input(bytes));
            answers.add(one);
        }
        return answers;
    }

    private Answer sum(List<Answer> answers, int most) {
        Answer all = new Answer(mesh.faces, mesh.fluxScale());
        answers.forEach(one -> all.add(one, most));
        return all;
    }

    /** What all shooters have ever shot. */
    List<Shot> totals() throws IOException {
        List<Shot> totals = new ArrayList<>();
        for (byte[] bytes : round(Order.plain(Order.Kind.TOTALS, 0))) {
            totals.addAll(Wire.shots(Wire.input(bytes)));
        }
        Collections.sort(totals);
        return totals;
    }

    /** The states of all blocks, by id. */
    abstract List<byte[]> blocks() throws IOException;

    /** Puts all blocks back to what {@link #blocks} had given. */
    abstract void restore(List<byte[]> states) throws IOException;

    @Override
    public void close() { }
}
