package radiosity.world;

import java.io.DataInputStream;
import java.io.IOException;

/**
 * What a host answers to a round.
 *
 * @param answer  as a {@link Partition} gives it
 * @param cpu     processor time that the round took, s
 * @param seconds wall time that the round took
 * @param work    1 per block that the host owns, in the order of their ids: its elements
 */
record Reply(byte[] answer, double cpu, double seconds, int[] work) {

    byte[] encode() {
        return Wire.bytes(out -> {
            out.writeDouble(cpu);
            out.writeDouble(seconds);
            out.writeInt(work.length);
            for (int w : work) {
                out.writeInt(w);
            }
            Wire.write(out, answer);
        });
    }

    static Reply decode(byte[] bytes) throws IOException {
        DataInputStream in = Wire.input(bytes);
        double cpu = in.readDouble();
        double seconds = in.readDouble();
        int[] work = new int[Wire.count(in, Integer.BYTES)];
        for (int b = 0; b < work.length; b++) {
            work[b] = in.readInt();
        }
        return new Reply(Wire.bytes(in), cpu, seconds, work);
    }
}
