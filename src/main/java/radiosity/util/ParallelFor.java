package radiosity.util;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;

/** A parallel loop: threads share numbered pieces of work. Which thread does which piece must not affect the result. */
public final class ParallelFor {

    /** Idle threads, shared by all loops, which end after a minute: starting one takes longer than many a loop. */
    private static final ExecutorService IDLE = Executors.newCachedThreadPool(work -> {
        Thread thread = new Thread(work, "radiosity");
        thread.setDaemon(true);
        return thread;
    });

    /** The least number of runs of pieces per thread. */
    private static final int RUNS = 16;
    /** How often the calling thread asks in a loop whether to go on, if that has so many pieces. */
    private static final int LOOKS = 8;

    private final int threads;
    private final BooleanSupplier goOn;

    /**
     * @param threads at least 1; no more threads are used than there are processors
     * @throws IllegalArgumentException where the number is below 1
     */
    public ParallelFor(int threads) {
        this(threads, () -> true);
    }

    private ParallelFor(int threads, BooleanSupplier goOn) {
        if (threads < 1) {
            throw new IllegalArgumentException("threads: expected at least 1, got " + threads);
        }
        this.threads = Math.min(threads, Math.max(1, Runtime.getRuntime().availableProcessors()));
        this.goOn = goOn;
    }

    /**
     * A loop that can be cancelled: a {@link CancellationException} ends it between two pieces.
     *
     * @param goOn called some {@link #LOOKS} times in each loop, by the calling thread only; false cancels the loop
     */
    public ParallelFor cancelledUnless(BooleanSupplier goOn) {
        return new ParallelFor(threads, goOn);
    }

    /** Whether a loop goes on, see {@link #cancelledUnless}; for the calling thread only. */
    public BooleanSupplier goOn() {
        return goOn;
    }

    /** Does the pieces 0 to count - 1 and returns when all are done; rethrows the first exception of a piece. */
    public void run(int count, IntConsumer piece) {
        Thread caller = Thread.currentThread();
        int every = Math.max(1, count / (LOOKS * threads));
        int[] mine = {0};
        IntConsumer checked = i -> {
            if (Thread.currentThread() == caller && mine[0]++ % every == 0 && !goOn.getAsBoolean()) {
                throw new CancellationException();
            }
            piece.accept(i);
        };
        if (threads == 1 || count <= 1) {
            for (int i = 0; i < count; i++) {
                checked.accept(i);
            }
            return;
        }
        AtomicInteger next = new AtomicInteger();
        AtomicReference<Throwable> failure = new AtomicReference<>();
        Runnable work = () -> {
            try {
                for (int i = next.getAndIncrement(); i < count; i = next.getAndIncrement()) {
                    checked.accept(i);
                }
            } catch (RuntimeException | Error e) {
                failure.compareAndSet(null, e);
                next.set(count);
            }
        };
        List<Future<?>> others = new ArrayList<>();
        try {
            for (int i = 1; i < Math.min(threads, count); i++) {
                others.add(IDLE.submit(work));
            }
        } catch (OutOfMemoryError e) {
            // the system gives no further thread; the threads that there are do all pieces
        }
        work.run();
        others.forEach(ParallelFor::await);
        Throwable thrown = failure.get();
        if (thrown instanceof Error error) {
            throw error;
        }
        if (thrown != null) {
            throw (RuntimeException) thrown;
        }
    }

    /** Does the pieces in runs of at most {@code most} neighbours; shorter runs where threads would soon be idle. */
    public void run(int count, int most, Run run) {
        int size = threads == 1 ? most : Math.max(1, Math.min(most, count / (threads * RUNS)));
        run((count + size - 1) / size, i -> run.of(i * size, Math.min(count, (i + 1) * size)));
    }

    /** Does the pieces {@code from} to {@code to - 1}. */
    public interface Run {
        void of(int from, int to);
    }

    /** Waits for a task. An interrupt is kept for the caller, as no piece of work may be left half done. */
    private static void await(Future<?> work) {
        boolean interrupted = false;
        for (boolean done = false; !done;) {
            try {
                work.get();
                done = true;
            } catch (InterruptedException e) {
                interrupted = true;
            } catch (ExecutionException e) {
                throw new IllegalStateException(e);
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
