package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.Block;

/**
 * Points at which partitions gather light for an estimate of the error, see {@link Order.Kind#GATHER_AT}. Each block
 * has a range of the points; the partition that owns the block gathers at them.
 *
 * @param place 3 per point: x, y, z in coordinates of the scene brought to size 1
 * @param face  1 per point: the face on which the point lies
 * @param key   1 per point: the number from which its rays follow
 * @param rays  1 per point: ordinal of {@link Rays}
 * @param slack 1 per point: powers of two by which the light that one ray may carry is raised, from 0
 * @param first 1 per block and one more: number of the block's first point; the last entry is the number of points
 */
public record GatherPoints(float[] place, int[] face, long[] key, byte[] rays, byte[] slack, int[] first) {

    private static final int BYTES = 3 * Float.BYTES + Integer.BYTES + Long.BYTES + 2 * Byte.BYTES;

    /** How finely rays sample the light at a point. */
    public enum Rays {
        /** Few rays, whose noise the estimate takes off. */
        COARSE,
        /** Rays finer than those of the solution. */
        FINE,
        /** The rays of the settings' form factors. */
        FORM_FACTORS
    }

    /** Number of points. */
    public int count() {
        return face.length;
    }

    /** The numbers of the points that some blocks have, ascending. */
    public int[] of(List<Block> blocks) {
        BitSet some = new BitSet(count());
        blocks.forEach(block -> some.set(first[block.id()], first[block.id() + 1]));
        return some.stream().toArray();
    }

    void write(DataOutputStream out) throws IOException {
        out.writeInt(count());
        ByteBuffer bytes = ByteBuffer.allocate(BYTES * count());
        for (int i = 0; i < count(); i++) {
            bytes.putFloat(place[3 * i]).putFloat(place[3 * i + 1]).putFloat(place[3 * i + 2]);
            bytes.putInt(face[i]).putLong(key[i]).put(rays[i]).put(slack[i]);
        }
        out.write(bytes.array());
        out.writeInt(first.length);
        for (int number : first) {
            out.writeInt(number);
        }
    }

    /** @throws IOException where the message is too short, or blocks have other points than those of the message */
    static GatherPoints read(DataInputStream in) throws IOException {
        int count = Wire.count(in, BYTES);
        ByteBuffer bytes = ByteBuffer.wrap(Wire.exactly(in, (long) BYTES * count));
        GatherPoints points = new GatherPoints(new float[3 * count], new int[count], new long[count], new byte[count],
                new byte[count], new int[Wire.count(in, Integer.BYTES)]);
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < 3; k++) {
                points.place[3 * i + k] = bytes.getFloat();
            }
            points.face[i] = bytes.getInt();
            points.key[i] = bytes.getLong();
            points.rays[i] = bytes.get();
            points.slack[i] = bytes.get();
        }
        for (int b = 0; b < points.first.length; b++) {
            points.first[b] = in.readInt();
        }
        if (IntStream.range(0, points.first.length)
                .anyMatch(b -> points.first[b] < (b == 0 ? 0 : points.first[b - 1]) || points.first[b] > count)) {
            throw new IOException("order: expected ascending numbers of up to " + count + " points");
        }
        return points;
    }
}
