package radiosity.solver;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import radiosity.mesh.Block;
import radiosity.partition.Partition;
import radiosity.partition.PartitionImpl;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;

/** A world whose elements are all in this process (section 4.5.2 of the paper). */
public final class LocalWorld extends World {

    private final List<Partition> partitions = new ArrayList<>();
    private final LongSupplier clock;
    /** Whether the work of partitions goes on; else it is cancelled. */
    private BooleanSupplier goOn = () -> true;

    /**
     * @param threads at least 1; no more than the number of processors are used
     * @throws IllegalArgumentException where the number of threads is below 1
     */
    public LocalWorld(Scene scene, RadiositySettings settings, int threads) {
        this(scene, settings, threads, 1);
    }

    /** Assigns the blocks to several partitions, as a network of hosts would. */
    public LocalWorld(Scene scene, RadiositySettings settings, int threads, int parts) {
        this(scene, settings, threads, parts, System::nanoTime);
    }

    /** @param clock time from an arbitrary origin, ns; without influence on the result */
    LocalWorld(Scene scene, RadiositySettings settings, int threads, int parts, LongSupplier clock) {
        super(scene, settings, threads);
        this.clock = clock;
        for (int p = 0; p < parts; p++) {
            int owner = p;
            List<Block> mine = mesh.blocks.stream().filter(b -> b.id() % parts == owner).toList();
            partitions.add(new PartitionImpl(mesh, mine, parallel.cancelledUnless(() -> goOn.getAsBoolean()), false));
        }
    }

    @Override
    public List<byte[]> round(Order order) throws IOException {
        List<byte[]> answers = new ArrayList<>();
        for (Partition partition : partitions) {
            answers.add(partition.round(order));
        }
        return answers;
    }

    @Override
    public void ask(Iterator<Order> orders, Answers answers, BooleanSupplier whileAsking) throws IOException {
        goOn = whileAsking;
        try {
            while (orders.hasNext()) {
                Order order = orders.next();
                answers.take(order, round(order));
            }
        } finally {
            goOn = () -> true;
        }
    }

    /** Takes the answers as objects, without encoding. */
    @Override
    List<Answer> answers(Order order) {
        return partitions.stream().map(partition -> partition.answer(order)).toList();
    }

    @Override
    public List<Shot> totals() {
        return joined(partitions.stream().flatMap(partition -> partition.totals().stream()).toList());
    }

    @Override
    public Begun begin(Order step, StepTimes times) {
        long begin = now();
        List<Answer> answers = answers(step);
        times.took(step.shots().size(), (now() - begin) * 1e-9);
        return later -> sum(answers, step.most());
    }

    @Override
    public void finish(StepTimes times) { }

    @Override
    public int stepsAhead() {
        return 1;
    }

    @Override
    public long now() {
        return clock.getAsLong();
    }

    @Override
    public List<byte[]> blocks() throws IOException {
        List<byte[]> states = new ArrayList<>();
        for (int b = 0; b < mesh.blocks.size(); b++) {
            states.add(owner(b).block(b));
        }
        return states;
    }

    @Override
    public void restore(List<byte[]> states) throws IOException {
        for (int b = 0; b < states.size(); b++) {
            owner(b).restore(b, states.get(b));
        }
    }

    private Partition owner(int block) {
        return partitions.get(block % partitions.size());
    }
}
