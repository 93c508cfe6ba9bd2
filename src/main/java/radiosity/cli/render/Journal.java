package radiosity.cli.render;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.zip.CRC32;
import java.util.zip.CheckedInputStream;
import java.util.zip.CheckedOutputStream;
import radiosity.cli.options.ErrorReport;
import radiosity.output.file.AtomicFile;
import radiosity.scene.SceneFormatException;
import radiosity.solution.SavedState;
import radiosity.solver.ProgressiveRadiosity;

/**
 * The journal of a render, {@code <output>.journal}: the state from which the same command resumes an interrupted
 * render, to the same bits.
 *
 * <p>The file contains a checksum, the settings, and the state between two rounds. The file is replaced as a whole when
 * the time since the last write exceeds a multiple of the time that the write took.
 */
public final class Journal {

    /** Time between writes in multiples of the time of a write: writing takes at most about a thirtieth of all time. */
    private static final int PATIENCE = 30;
    /** Lower bound of the time of a write, ns. */
    private static final long LEAST_COST = 50_000_000;

    private final Path file;
    private final String settings;
    private final Consumer<String> notices;
    private long cost = LEAST_COST;
    private final LongSupplier clock;
    private long last;
    private boolean failed;
    /** Whether the file is a journal of this render. */
    private boolean kept;

    /**
     * @param claim    to the journal's file; must be held while the journal is in use
     * @param settings text that must be the same in the interrupted and the resuming render
     * @param notices  receives messages to the user
     * @param clock    nanoseconds, used for differences only
     */
    public Journal(JournalClaim claim, String settings, Consumer<String> notices, LongSupplier clock) {
        file = claim.journal();
        this.settings = settings;
        this.notices = notices;
        this.clock = clock;
        last = clock.getAsLong();
    }

    /** The path of the journal of a scene file. */
    public static Path of(Path output) {
        return Path.of(output + ".journal");
    }

    /**
     * Resumes a calculation from the journal. A journal that is damaged or of another render only gives a warning.
     *
     * @return whether the calculation was resumed
     */
    public boolean resume(ProgressiveRadiosity radiosity) throws IOException {
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try {
            radiosity.resume(read());
            kept = true;
            notices.accept(file + ": going on after " + radiosity.shots() + " shots of a render that was cut off");
            return true;
        } catch (SceneFormatException e) {
            notices.accept("warning: " + e.getMessage() + "; it is replaced");
            return false;
        }
    }

    /**
     * Reads the file in one pass; the state of a render with other settings is skipped.
     *
     * @throws SceneFormatException where the file is damaged, no journal, or the journal of a render with other
     *                              settings
     */
    private SavedState read() throws IOException {
        CRC32 sum = new CRC32();
        long left = Files.size(file) - Long.BYTES - Integer.BYTES;
        try (InputStream bytes = new BufferedInputStream(Files.newInputStream(file));
             DataInputStream in = new DataInputStream(new CheckedInputStream(bytes, sum))) {
            if (left < 0) {
                throw wrong("a journal", "another file");
            }
            long expected = new DataInputStream(bytes).readLong();
            int length = in.readInt();
            if (length < 0 || length > left) {
                throw wrong("a journal", "another file");
            }
            boolean isSame = Arrays.equals(in.readNBytes(length), utf8());
            SavedState state = SavedState.NONE;
            if (isSame) {
                state = SavedState.read(in, left - length);
            } else {
                in.transferTo(OutputStream.nullOutputStream());
            }
            if (sum.getValue() != expected) {
                throw wrong("a journal", "another file");
            }
            if (!isSame) {
                throw wrong("the journal of the same render", "that of another");
            }
            return state;
        }
    }

    private byte[] utf8() {
        return settings.getBytes(StandardCharsets.UTF_8);
    }

    private SceneFormatException wrong(String expected, String got) {
        return new SceneFormatException(file.toString(), "", expected, got);
    }

    /** Supplies the state to be written. */
    public interface Source {
        SavedState state() throws IOException;
    }

    /** Writes the state if a write is due. */
    public void keep(Source source) throws IOException {
        if (clock.getAsLong() - last >= PATIENCE * cost) {
            keepNow(source);
        }
    }

    /**
     * Writes the state. A write that fails for lack of disk space or memory does not stop the render; the first such
     * failure of a render gives a warning.
     *
     * @throws IOException where a partition cannot be reached
     */
    public void keepNow(Source source) throws IOException {
        long begin = clock.getAsLong();
        try {
            SavedState state = source.state();
            try {
                write(state);
                kept = true;
            } catch (IOException e) {
                warn(ErrorReport.reason(e));
            }
        } catch (OutOfMemoryError e) {
            warn(ErrorReport.line(e));
        }
        last = clock.getAsLong();
        cost = Math.max(LEAST_COST, last - begin);
    }

    /** Writes the final state, whose scene file could not be written; returns for the user what is kept of the work. */
    public String keepResult(SavedState state) throws IOException {
        keepNow(() -> state);
        return kept ? "the same command goes on from " + file : "nothing was kept";
    }

    private void warn(String got) {
        if (!failed) {
            failed = true;
            notices.accept("warning: " + file + ": expected to be written, got " + got
                    + "; without it a render that is cut off begins anew");
        }
    }

    private void write(SavedState state) throws IOException {
        CheckedOutputStream summed = new CheckedOutputStream(OutputStream.nullOutputStream(), new CRC32());
        writeSummed(state, summed);
        AtomicFile.write(file, channel -> {
            DataOutputStream out = new DataOutputStream(Channels.newOutputStream(channel));
            out.writeLong(summed.getChecksum().getValue());
            writeSummed(state, out);
        });
    }

    /** Writes everything that the checksum covers: the length of the settings, the settings, the state. */
    private void writeSummed(SavedState state, OutputStream to) throws IOException {
        new DataOutputStream(to).writeInt(utf8().length);
        to.write(utf8());
        state.writeTo(to);
    }

    /** Deletes the journal of a render that is done and saved. */
    public void delete() throws IOException {
        Files.deleteIfExists(file);
    }
}
