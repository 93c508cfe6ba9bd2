package radiosity.protocol;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;

/** The scene and the settings of a saved calculation, at the end of its state. */
public final class SavedScene {

    /** What the last four bytes of a state with a scene are. */
    private static final int MARK = 0x53434e31;
    /** Length and mark. */
    private static final int TAIL = 8;

    private SavedScene() { }

    /** @param scene as {@link SceneBytes} writes it */
    public static byte[] write(byte[] scene) {
        Deflater quick = new Deflater(Deflater.BEST_SPEED);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(new DeflaterOutputStream(packed, quick))) {
            Wire.write(out, scene);
        } catch (IOException e) {
            throw new IllegalStateException("writing to memory cannot fail", e);
        } finally {
            quick.end();
        }
        return Wire.bytes(out -> {
            out.write(packed.toByteArray());
            out.writeInt(packed.size());
            out.writeInt(MARK);
        });
    }

    /**
     * Reads the scene at the end of a state.
     *
     * @param state  opened anew each time
     * @param length of the state, bytes
     * @return nothing where the state has none, as those of older programs
     */
    public static Optional<SceneBytes.Task> read(Supplier<InputStream> state, long length) throws IOException {
        if (length < TAIL) {
            return Optional.empty();
        }
        DataInputStream tail = at(state, length - TAIL);
        int packed = tail.readInt();
        if (tail.readInt() != MARK || packed < 0 || packed > length - TAIL) {
            return Optional.empty();
        }
        try (DataInputStream scene = new DataInputStream(new InflaterInputStream(
                at(state, length - TAIL - packed)))) {
            return Optional.of(SceneBytes.read(Wire.input(scene.readNBytes(scene.readInt()))));
        }
    }

    private static DataInputStream at(Supplier<InputStream> state, long place) throws IOException {
        InputStream in = state.get();
        in.skipNBytes(place);
        return new DataInputStream(in);
    }
}
