package radiosity.cli.render;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import radiosity.cli.terminal.StopRequest;

/**
 * Delays the end of the process on Ctrl-C or SIGTERM until the step under way is done and saved, but only for a limited
 * time; a render that takes longer to save is left to its journal.
 *
 * <p>Uses a shutdown hook, so that the exit code of the process stays the one of the signal: 130 or 143.
 */
public final class SaveBeforeExit implements AutoCloseable {

    /** Longest delay: the process is to end within 10 s after a signal, of which the JVM needs a part. */
    public static final Duration PATIENCE = Duration.ofSeconds(9);
    /** Longest wait for the output of a message: a terminal that was stopped with Ctrl-S accepts none. */
    private static final long MESSAGE_MILLISECONDS = 300;

    private final StopRequest stop;
    private final Duration patience;
    private final CountDownLatch saved = new CountDownLatch(1);
    private final Thread hook = new Thread(this::stopAndWait, "save before exit");
    private boolean begun;
    private volatile Optional<Path> journal = Optional.empty();

    /** @param patience longest time that a signal waits until everything is saved */
    public SaveBeforeExit(StopRequest stop, Duration patience) {
        this.stop = stop;
        this.patience = patience;
    }

    /**
     * Makes signals wait, from this call until {@link #close}, for results to be saved; called for each frame.
     *
     * @param kept journal of the calculation that begins, where it has one
     */
    public void begin(Optional<Path> kept) {
        journal = kept;
        if (begun) {
            return;
        }
        begun = true;
        try {
            Runtime.getRuntime().addShutdownHook(hook);
        } catch (IllegalStateException e) {
            stop.make(); // a signal has already begun the shutdown
        }
    }

    private void stopAndWait() {
        Thread request = apart(stop::make);
        try {
            if (!saved.await(patience.toMillis(), TimeUnit.MILLISECONDS)) {
                apart(() -> stop.say("ending before everything is saved" + rest())).join(MESSAGE_MILLISECONDS);
            } else {
                request.join(MESSAGE_MILLISECONDS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private String rest() {
        return journal.filter(Files::exists).map(file -> "; the same command goes on from " + file).orElse("");
    }

    /** Starts a thread that prints a message, which may block. */
    private static Thread apart(Runnable message) {
        Thread thread = new Thread(message, "message before exit");
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    /** Lets a waiting signal end the process: everything is saved. */
    @Override
    public void close() {
        saved.countDown();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // the process is ending, and the hook has done its work
        }
    }
}
