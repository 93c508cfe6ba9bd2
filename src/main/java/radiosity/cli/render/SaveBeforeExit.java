package radiosity.cli.render;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import radiosity.cli.terminal.StopRequest;

/**
 * Holds up the end of the program on Ctrl-C or SIGTERM until the current round is done and saved, but not for long:
 * what takes longer to save is left to the journal.
 *
 * <p>A shutdown hook, so the program's exit code stays what the signal makes it: 130 or 143.
 */
public final class SaveBeforeExit implements AutoCloseable {

    /** From a signal to the end of the program take at most 10 s, of which the JVM needs some to end. */
    public static final Duration PATIENCE = Duration.ofSeconds(9);
    /** How long a message may take: a terminal that was stopped with Ctrl-S takes none. */
    private static final long MESSAGE_MILLISECONDS = 300;

    private final StopRequest stop;
    private final Duration patience;
    private final CountDownLatch saved = new CountDownLatch(1);
    private final Thread hook = new Thread(this::stopAndWait, "save before exit");
    private boolean begun;
    private volatile Optional<Path> journal = Optional.empty();

    /** @param patience how long a signal waits for the end of saving */
    public SaveBeforeExit(StopRequest stop, Duration patience) {
        this.stop = stop;
        this.patience = patience;
    }

    /**
     * From now on, until closed, there is something to save; frames begin one after another.
     *
     * @param kept journal of it, where there is one
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
            stop.make(); // the program is ending already
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

    /** Runs what prints a message without waiting for it. */
    private static Thread apart(Runnable message) {
        Thread thread = new Thread(message, "message before exit");
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    /** Everything is saved. */
    @Override
    public void close() {
        saved.countDown();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // the program is ending, and the hook has done its work
        }
    }
}
