package radiosity.cli.render;

import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.ThreadLocalRandom;
import radiosity.cli.options.Failure;
import radiosity.output.file.AtomicFile;
import radiosity.output.file.LockedFile;

/**
 * The exclusive right of a process to a journal: while it is held, no other process resumes from the journal, replaces
 * it or deletes it.
 *
 * <p>The claim is a locked file in the directory of the journal, named after the journal. The claim of a process that
 * is killed ends with the process.
 */
public final class JournalClaim implements Closeable {

    /** Attempts to claim: processes that start at the same moment see each other's claims, withdraw and try again. */
    private static final int ATTEMPTS = 6;
    private static final int MOST_WAIT_MILLISECONDS = 100;

    private final Path journal;
    private final LockedFile claim;

    private JournalClaim(Path journal, LockedFile claim) {
        this.journal = journal;
        this.claim = claim;
    }

    /**
     * Claims a journal, whether or not its file exists.
     *
     * @throws Failure where another running process holds the journal
     */
    public static JournalClaim of(Path journal) throws IOException {
        Path place = AtomicFile.target(journal);
        String kind = UUID.nameUUIDFromBytes(place.getFileName().toString().getBytes(StandardCharsets.UTF_8))
                + "-claim";
        for (int attempt = 1;; attempt++) {
            LockedFile own = LockedFile.create(place.getParent(), kind);
            List<Long> owners = LockedFile.sweep(place.getParent(), kind);
            owners.remove(ProcessHandle.current().pid());
            if (owners.isEmpty()) {
                return new JournalClaim(journal, own);
            }
            own.close();
            if (attempt == ATTEMPTS) {
                throw Failure.file(journal, "expected a journal that no other render is using, got that of process "
                        + owners.get(0) + ", which is running", null);
            }
            pause();
        }
    }

    private static void pause() {
        try {
            Thread.sleep(ThreadLocalRandom.current().nextInt(MOST_WAIT_MILLISECONDS) + 1);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Path of the claimed journal. */
    public Path journal() {
        return journal;
    }

    @Override
    public void close() throws IOException {
        claim.close();
    }
}
