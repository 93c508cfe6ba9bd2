package radiosity.protocol;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;

/**
 * The reply of a host to one order.
 *
 * @param answer  the answer of the host's {@code Partition}, as bytes
 * @param cpu     processor time that the order took, s
 * @param seconds wall time that the order took, s
 * @param work    1 per block that the host owns, in the order of the blocks' ids
 * @param given   ghost values for other hosts, see {@code GhostVertices.give}; empty where the order asks for none
 */
public record Reply(byte[] answer, double cpu, double seconds, List<BlockWork> work, byte[] given) {

    public byte[] encode() {
        return Wire.bytes(out -> {
            out.writeDouble(cpu);
            out.writeDouble(seconds);
            out.writeInt(work.size());
            for (BlockWork block : work) {
                block.write(out);
            }
            Wire.write(out, answer);
            Wire.write(out, given);
        });
    }

    public static Reply decode(byte[] bytes) throws IOException {
        DataInputStream in = Wire.input(bytes);
        double cpu = in.readDouble();
        double seconds = in.readDouble();
        BlockWork[] work = new BlockWork[Wire.count(in, BlockWork.BYTES)];
        ByteBuffer ofBlocks = ByteBuffer.wrap(Wire.exactly(in, (long) BlockWork.BYTES * work.length));
        for (int b = 0; b < work.length; b++) {
            work[b] = BlockWork.read(ofBlocks);
        }
        return new Reply(Wire.bytes(in), cpu, seconds, List.of(work), Wire.bytes(in));
    }

    public int elements() {
        return work.stream().mapToInt(BlockWork::elements).sum();
    }
}
