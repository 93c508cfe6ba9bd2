package radiosity.cli;

import java.util.concurrent.CountDownLatch;

/**
 * Holds up the end of the program on Ctrl-C or SIGTERM until the current round is done and saved.
 *
 * <p>A shutdown hook, so the program's exit code stays what the signal makes it: 130 or 143.
 */
final class SaveBeforeExit implements AutoCloseable {

    private final StopRequest stop;
    private final CountDownLatch saved = new CountDownLatch(1);
    private final Thread hook = new Thread(this::stopAndWait, "save before exit");

    SaveBeforeExit(StopRequest stop) {
        this.stop = stop;
    }

    /** From now on, until closed, there is something to save. */
    void begin() {
        try {
            Runtime.getRuntime().addShutdownHook(hook);
        } catch (IllegalStateException e) {
            stop.make(); // the program is ending already
        }
    }

    private void stopAndWait() {
        stop.make();
        try {
            saved.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
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
