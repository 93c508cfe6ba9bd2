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

/** Writes and reads the part of a saved calculation's state that holds its scene and settings: the state's end. */
public final class SavedScene {

    /** The last four bytes of a state that ends with a scene: SCN1 in ASCII. */
    private static final int MARK = 0x53434e31;
    /** Bytes behind the compressed scene: the number of its bytes and the mark. */
    private static final int TAIL = 8;

    private SavedScene() { }

    /** Compresses a scene, given as {@link SceneBytes} writes it, for the end of a state. */
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
     * @param state  opens the state at its first byte, once per call
     * @param length bytes of the state
     * @return empty where the state ends without a scene, as states of older versions of the program do
     * @throws IOException where the scene cannot be read
     */
    public static Optional<SceneBytes.Task> read(Supplier<InputStream> state, long length) throws IOException {
        if (length < TAIL) {
            return Optional.empty();
        }
        int packed;
        try (DataInputStream tail = at(state, length - TAIL)) {
            packed = tail.readInt();
            if (tail.readInt() != MARK || packed < 0 || packed > length - TAIL) {
                return Optional.empty();
            }
        }
        try (DataInputStream scene = new DataInputStream(new InflaterInputStream(
                at(state, length - TAIL - packed)))) {
            int bytes = scene.readInt();
            if (bytes < 0) {
                throw new IOException("saved scene: expected a number of bytes from 0 on, got " + bytes);
            }
            return Optional.of(SceneBytes.read(Wire.input(scene.readNBytes(bytes))));
        }
    }

    private static DataInputStream at(Supplier<InputStream> state, long place) throws IOException {
        InputStream in = state.get();
        in.skipNBytes(place);
        return new DataInputStream(in);
    }
}
