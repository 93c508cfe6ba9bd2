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
 * The right of one process to a journal: no other may go on from it, replace it or delete it meanwhile.
 *
 * <p>A locked file beside the journal, named after it; so the claim of a process that is killed ends with it.
 */
public final class JournalClaim implements Closeable {

    /** Processes that begin at the same moment see each other's claims, and withdraw theirs so often. */
    private static final int ATTEMPTS = 6;
    private static final int MOST_WAIT_MILLISECONDS = 100;

    private final Path journal;
    private final LockedFile claim;

    private JournalClaim(Path journal, LockedFile claim) {
        this.journal = journal;
        this.claim = claim;
    }

    /**
     * Claims a journal, whether it exists already or not.
     *
     * @throws Failure where a live process has it
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

    /** The file that is claimed. */
    public Path journal() {
        return journal;
    }

    @Override
    public void close() throws IOException {
        claim.close();
    }
}
