package radiosity.world;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInput;
import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;

/** To bytes and back. */
final class Wire {

    private Wire() { }

    /** Writes to memory, which cannot fail. */
    interface Writer {
        void write(DataOutputStream out) throws IOException;
    }

    static byte[] bytes(Writer writer) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            writer.write(out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    static DataInputStream input(byte[] bytes) {
        return new DataInputStream(new ByteArrayInputStream(bytes));
    }

    static void write(List<Shot> shots, int channels, DataOutput out) throws IOException {
        out.writeInt(channels);
        out.writeInt(shots.size());
        for (Shot shot : shots) {
            shot.write(out);
        }
    }

    static List<Shot> shots(DataInput in) throws IOException {
        int channels = in.readInt();
        List<Shot> shots = new ArrayList<>();
        for (int n = in.readInt(); n > 0; n--) {
            shots.add(Shot.read(in, channels));
        }
        return shots;
    }
}
