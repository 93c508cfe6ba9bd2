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
import radiosity.settings.RadiositySettings;
import radiosity.solution.SavedState;
import radiosity.solver.ProgressiveRadiosity;

/**
 * What a render that is cut off leaves behind: {@code <output>.journal}. The same command then goes on from there, to
 * the same bits.
 *
 * <p>Checksum, settings, and the state between two rounds; replaced as a whole whenever the rounds since have taken a
 * multiple of the time that writing it takes.
 */
public final class Journal {

    /** Of all time, at most a thirtieth goes into the journal. */
    private static final int PATIENCE = 30;
    /** What writing is taken to cost at least, ns. */
    private static final long LEAST_COST = 50_000_000;

    private final Path file;
    private final String settings;
    private final Consumer<String> notices;
    private long cost = LEAST_COST;
    private final LongSupplier clock;
    private long last;
    private boolean failed;

    /**
     * @param claim to its file, held as long as the journal is in use
     * @param clock for differences, ns
     */
    public Journal(JournalClaim claim, RadiositySettings settings, Consumer<String> notices, LongSupplier clock) {
        this(claim, settings.toString(), notices, clock);
    }

    /** @param settings in words, with what else a render must have in common with one that was cut off */
    public Journal(JournalClaim claim, String settings, Consumer<String> notices, LongSupplier clock) {
        file = claim.journal();
        this.settings = settings;
        this.notices = notices;
        this.clock = clock;
        last = clock.getAsLong();
    }

    /** Where the journal of a scene file is. */
    public static Path of(Path output) {
        return Path.of(output + ".journal");
    }

    /** Whether there was something to go on from. */
    public boolean resume(ProgressiveRadiosity radiosity) throws IOException {
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try {
            radiosity.resume(read());
            notices.accept(file + ": going on after " + radiosity.shots() + " shots of a render that was cut off");
            return true;
        } catch (SceneFormatException e) {
            notices.accept("warning: " + e.getMessage() + "; it is replaced");
            return false;
        }
    }

    /** Reads the file once; the state of another render is not kept. */
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

    /** Where the state to be written comes from. */
    public interface Source {
        SavedState state() throws IOException;
    }

    /** Writes the state where that is due. */
    public void keep(Source source) throws IOException {
        if (clock.getAsLong() - last >= PATIENCE * cost) {
            keepNow(source);
        }
    }

    /**
     * Writes the state. That it cannot be written, for want of disk or memory, gives one warning in the whole render
     * and is no reason to stop.
     *
     * @throws IOException where a partition cannot be reached
     */
    public void keepNow(Source source) throws IOException {
        long begin = clock.getAsLong();
        try {
            SavedState state = source.state();
            try {
                write(state);
            } catch (IOException e) {
                warn(ErrorReport.reason(e));
            }
        } catch (OutOfMemoryError e) {
            warn(ErrorReport.line(e));
        }
        last = clock.getAsLong();
        cost = Math.max(LEAST_COST, last - begin);
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

    /** Writes everything that the checksum is of. */
    private void writeSummed(SavedState state, OutputStream to) throws IOException {
        new DataOutputStream(to).writeInt(utf8().length);
        to.write(utf8());
        state.writeTo(to);
    }

    /** The render is done, and saved. */
    public void delete() throws IOException {
        Files.deleteIfExists(file);
    }
}
