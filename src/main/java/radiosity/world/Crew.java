package radiosity.world;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.IntConsumer;

/** Threads that share out numbered pieces of work; which does which has no influence on the result. */
final class Crew {

    private final int threads;

    /** @param threads at least 1 */
    Crew(int threads) {
        this.threads = Math.min(threads, Math.max(1, Runtime.getRuntime().availableProcessors()));
    }

    /** Does the pieces 0 to count - 1 and returns when all are done; what a piece throws is thrown on. */
    void run(int count, IntConsumer piece) {
        if (threads == 1 || count <= 1) {
            for (int i = 0; i < count; i++) {
                piece.accept(i);
            }
            return;
        }
        AtomicInteger next = new AtomicInteger();
        AtomicReference<Throwable> failure = new AtomicReference<>();
        Runnable work = () -> {
            try {
                for (int i = next.getAndIncrement(); i < count; i = next.getAndIncrement()) {
                    piece.accept(i);
                }
            } catch (RuntimeException | Error e) {
                failure.compareAndSet(null, e);
                next.set(count);
            }
        };
        Thread[] others = new Thread[Math.min(threads, count) - 1];
        for (int i = 0; i < others.length; i++) {
            others[i] = new Thread(work, "radiosity-" + i);
            others[i].setDaemon(true);
            others[i].start();
        }
        work.run();
        for (Thread other : others) {
            join(other);
        }
        Throwable thrown = failure.get();
        if (thrown instanceof Error error) {
            throw error;
        }
        if (thrown != null) {
            throw (RuntimeException) thrown;
        }
    }

    /** The same in runs of neighbouring pieces, for what is quickly done. */
    void run(int count, int size, Run run) {
        run((count + size - 1) / size, i -> run.of(i * size, Math.min(count, (i + 1) * size)));
    }

    /** Does the pieces from one up to another one, which is left out. */
    interface Run {
        void of(int from, int to);
    }

    /** An interrupt is kept for the caller: a piece of work is not left half done. */
    private static void join(Thread thread) {
        boolean interrupted = false;
        while (thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
