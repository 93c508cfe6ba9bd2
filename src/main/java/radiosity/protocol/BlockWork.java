package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.IOException;

/**
 * What a block holds, and what a round took of it.
 *
 * @param elements that it has now
 * @param points   receiving points that it has now
 * @param gathered points at which was gathered; one that several blocks of a host share counts for one of them
 * @param seconds  processor time
 */
public record BlockWork(int elements, int points, int gathered, float seconds) {

    static final int BYTES = 3 * Integer.BYTES + Float.BYTES;

    void write(DataOutput out) throws IOException {
        out.writeInt(elements);
        out.writeInt(points);
        out.writeInt(gathered);
        out.writeFloat(seconds);
    }

    static BlockWork read(DataInputStream in) throws IOException {
        return new BlockWork(in.readInt(), in.readInt(), in.readInt(), in.readFloat());
    }
}
