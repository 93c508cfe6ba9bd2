package radiosity.world;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.List;

/**
 * What every partition does in a round.
 *
 * @param kind      what it is
 * @param number    counts the rounds of a calculation from 1
 * @param shots     who shoots, in the order in which it is applied
 * @param tolerance how much one ray may carry, see {@link radiosity.formfactor.RayCaster}
 * @param weight    one per channel: what a W/m² counts for in that
 * @param meshError how much interpolation on one element may add to the error of the whole, relative to its mean
 * @param most      how many candidates for the next round to name
 */
record Order(Kind kind, int number, List<Shot> shots, double tolerance, double[] weight, double meshError, int most) {

    /** The kinds of round. */
    enum Kind {
        /** Say who could shoot. */
        ASK,
        /** Mark who shoots, gather at every vertex; subdivide by the paper's rule where that is on. */
        SHOOT,
        /** The same without subdivision: the rest of the round follows. */
        SHOOT_ON,
        /** Subdivide where interpolation errs, and gather at the new vertices all that was ever shot. */
        REFINE,
        /** Say what was ever shot. */
        TOTALS,
        /** Say, for the initial mesh's vertices, how much of each patch they see: rows of a {@link CoarseSystem}. */
        ROWS
    }

    /** A part of this round; only the last part ends it. */
    Order cut(int round, int from, int to) {
        return new Order(to == shots.size() ? Kind.SHOOT : Kind.SHOOT_ON, round, shots.subList(from, to), tolerance,
                weight, meshError, most);
    }

    byte[] encode() {
        return Wire.bytes(this::write);
    }

    private void write(DataOutputStream out) throws IOException {
        out.writeByte(kind.ordinal());
        out.writeInt(number);
        out.writeInt(shots.size());
        for (Shot shot : shots) {
            shot.write(out);
        }
        out.writeDouble(tolerance);
        out.writeInt(weight.length);
        for (double w : weight) {
            out.writeDouble(w);
        }
        out.writeDouble(meshError);
        out.writeInt(most);
    }

    static Order decode(byte[] bytes) throws IOException {
        DataInputStream in = Wire.input(bytes);
        Kind kind = Kind.values()[in.readByte()];
        int number = in.readInt();
        List<Shot> shots = Wire.shots(in);
        double tolerance = in.readDouble();
        double[] weight = new double[in.readInt()];
        for (int c = 0; c < weight.length; c++) {
            weight[c] = in.readDouble();
        }
        return new Order(kind, number, shots, tolerance, weight, in.readDouble(), in.readInt());
    }
}
