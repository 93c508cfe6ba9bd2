package radiosity.protocol;

import java.io.DataOutput;
import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * The size of a block, and the work on it since the last report.
 *
 * @param elements number of elements of the block
 * @param points   number of receiving points of the block
 * @param gathered number of receiving points that gathered; a point of several blocks of a host counts for one of them
 * @param seconds  processor time spent on the block, s
 */
public record BlockWork(int elements, int points, int gathered, float seconds) {

    static final int BYTES = 3 * Integer.BYTES + Float.BYTES;

    void write(DataOutput out) throws IOException {
        out.writeInt(elements);
        out.writeInt(points);
        out.writeInt(gathered);
        out.writeFloat(seconds);
    }

    static BlockWork read(ByteBuffer in) {
        return new BlockWork(in.getInt(), in.getInt(), in.getInt(), in.getFloat());
    }
}
