package radiosity.cli;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.zip.CRC32;
import radiosity.output.WholeFile;
import radiosity.scene.SceneFormatException;
import radiosity.world.ProgressiveRadiosity;
import radiosity.world.RadiositySettings;

/**
 * What a render that is cut off leaves behind: {@code <output>.journal}. The same command then goes on from there, to
 * the same bits.
 *
 * <p>Checksum, settings, and the state between two rounds; replaced as a whole whenever the rounds since have taken a
 * multiple of the time that writing it takes.
 */
final class Journal {

    /** Of all time, at most a thirtieth goes into the journal. */
    private static final int PATIENCE = 30;
    /** What writing is taken to cost at least, ns. */
    private static final long LEAST_COST = 50_000_000;

    private final Path file;
    private final String settings;
    private final Consumer<String> notices;
    private long cost = LEAST_COST;
    private long last = System.nanoTime();
    private boolean failed;

    /** @param output the scene file */
    Journal(Path output, RadiositySettings settings, Consumer<String> notices) {
        file = Path.of(output + ".journal");
        this.settings = settings.toString();
        this.notices = notices;
    }

    /** Whether there was something to go on from. */
    boolean resume(ProgressiveRadiosity radiosity) throws IOException {
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

    private byte[] read() throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
            long sum = bytes.length < Long.BYTES ? -1 : in.readLong();
            if (sum != checksum(bytes)) {
                throw wrong("a journal", "another file");
            }
            String before = new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8);
            if (!before.equals(settings)) {
                throw wrong("the journal of the same render", "that of another");
            }
            return in.readAllBytes();
        }
    }

    private SceneFormatException wrong(String expected, String got) {
        return new SceneFormatException(file.toString(), "", expected, got);
    }

    private static long checksum(byte[] bytes) {
        CRC32 sum = new CRC32();
        sum.update(bytes, Math.min(bytes.length, Long.BYTES), Math.max(0, bytes.length - Long.BYTES));
        return sum.getValue();
    }

    /** Writes it where that is due; that it cannot be is told once, and no reason to stop. */
    void keep(ProgressiveRadiosity radiosity) throws IOException {
        long begin = System.nanoTime();
        if (begin - last < PATIENCE * cost) {
            return;
        }
        byte[] state = radiosity.state();
        try {
            write(state);
        } catch (IOException e) {
            if (!failed) {
                notices.accept("warning: " + file + ": expected to be written, got " + FileChecks.reason(e)
                        + "; without it a render that is cut off begins anew");
            }
            failed = true;
        }
        last = System.nanoTime();
        cost = Math.max(LEAST_COST, last - begin);
    }

    private void write(byte[] state) throws IOException {
        byte[] told = settings.getBytes(StandardCharsets.UTF_8);
        ByteBuffer bytes = ByteBuffer.allocate(Long.BYTES + Integer.BYTES + told.length + state.length);
        bytes.putLong(0).putInt(told.length).put(told).put(state);
        bytes.putLong(0, checksum(bytes.array()));
        WholeFile.write(file, bytes.array());
    }

    /** The render is done, and saved. */
    void delete() throws IOException {
        Files.deleteIfExists(file);
    }
}
