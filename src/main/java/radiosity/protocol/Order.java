package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import radiosity.prediction.CoarseSystem;
import radiosity.worker.ShotHistory;

/**
 * What every partition does in a round, or in a part of one.
 *
 * @param kind      what it is
 * @param number    counts the rounds of a calculation from 1
 * @param more      whether the rest of the round follows
 * @param shots     who shoots, in the order in which it is applied
 * @param tolerance how much one ray may carry, see {@link radiosity.formfactor.RayCaster}
 * @param weight    what a W/m² counts for in that, see {@link radiosity.mesh.Weights}
 * @param meshError how much interpolation on one element may add to the error of the whole, relative to its mean
 * @param ambient   channels per closed room, see {@link radiosity.mesh.UniformRadiosity}; empty: none. W/m²
 * @param givenBack one per channel, or empty: part of what each vertex has received that it receives besides
 * @param begun     whether a part of the round is done: the ambient light has been received
 * @param most      how many candidates for the next round to name; -1: nobody reads the answer; {@link #GIVE}:
 *                  gather only where other hosts need it, and say what has arrived there
 * @param least     unshot flux that a candidate has at least, W
 */
public record Order(Kind kind, int number, boolean more, List<Shot> shots, double tolerance, double[] weight,
             double meshError, double[] ambient, double[] givenBack, boolean begun, int most, double least) {

    public static final int GIVE = -2;
    private static final double[] NONE = {};

    /** The kinds of round. */
    public enum Kind {
        /** Say who could shoot. */
        ASK,
        /** Mark who shoots, gather at every vertex; at the end subdivide by the paper's rule where that is on. */
        SHOOT,
        /** Subdivide where interpolation errs; new vertices are dark. */
        SPLIT,
        /** Gather at the vertices that the round before has made: nobody is marked. */
        GATHER,
        /** Mark who shoots, and set aside what all vertices have received: they are dark until they have gathered. */
        RENEW,
        /** Gather at all vertices what was ever shot, along other rays than before: nobody is marked. */
        REGATHER,
        /** Average what was gathered anew with what was set aside, where that is not negative. */
        AVERAGE,
        /** Give all vertices back what rays have lost, see {@link Order#givenBack}. */
        BALANCE,
        /** Say what was ever shot. */
        TOTALS,
        /** Say what is unshot, to the last digit; no corner is to have shot less than nothing. */
        UNSHOT,
        /** Say how all trees are divided. */
        TREES,
        /** Say who could shoot, on the patches of the coarse mesh: their means. */
        MEANS,
        /** Say, for the coarse mesh's vertices, how much of each patch they see: rows of a {@link CoarseSystem}. */
        ROWS,
        /** Gather where an order with {@link #GIVE} has left it for later: at the points that no other host needs. */
        REST
    }

    /** An order without shots. */
    public static Order plain(Kind kind, int most) {
        return new Order(kind, 0, false, List.of(), 0, new double[0], 0, NONE, NONE, false, most, 0);
    }

    /** An order without ambient light. */
    public static Order of(Kind kind, List<Shot> shots, double tolerance, double[] weight, double meshError, int most) {
        return new Order(kind, 0, false, shots, tolerance, weight, meshError, NONE, NONE, false, most, 0);
    }

    public Order numbered(int round) {
        return new Order(kind, round, more, shots, tolerance, weight, meshError, ambient, givenBack, begun,
                most, least);
    }

    /** The first shots of this round; candidates are named when it ends. */
    public Order first(int size) {
        boolean all = size == shots.size();
        return new Order(kind, number, !all, shots.subList(0, size), tolerance, weight, meshError, ambient, givenBack,
                begun, all ? most : 0, least);
    }

    /** What is left of this round without its first shots. */
    public Order after(int size) {
        return new Order(kind, number, more, shots.subList(size, shots.size()), tolerance, weight, meshError, ambient,
                givenBack, true, most, least);
    }

    /** All of it, in parts of up to so many shots. */
    public List<Order> parts(int size) {
        List<Order> parts = new ArrayList<>();
        Order rest = this;
        for (int left = shots.size(); left > size; left -= size) {
            parts.add(rest.first(size));
            rest = rest.after(size);
        }
        parts.add(rest);
        return parts;
    }

    /** Whether elements are others afterwards: what is not asked only, and is to be done again for a lost block. */
    public boolean changes() {
        return gathers() || kind == Kind.SPLIT || kind == Kind.RENEW || kind == Kind.AVERAGE
                || kind == Kind.BALANCE;
    }

    /** Whether points gather. */
    public boolean gathers() {
        return kind == Kind.SHOOT || gathersTotals();
    }

    /** Whether points gather all that was ever shot: hosts know it, and are not sent it. */
    public boolean gathersTotals() {
        return kind == Kind.GATHER || kind == Kind.REGATHER;
    }

    /** Whether what is shot counts as shot from now on. */
    public boolean marks() {
        return kind == Kind.SHOOT || kind == Kind.RENEW;
    }

    /** The same, naming other numbers of candidates. */
    public Order naming(int candidates) {
        return new Order(kind, number, more, shots, tolerance, weight, meshError, ambient, givenBack, begun,
                candidates, least);
    }

    /** The same, and all receive this besides. */
    public Order givingBack(double[] even) {
        return new Order(kind, number, more, shots, tolerance, weight, meshError, ambient, even, begun, most,
                least);
    }

    public boolean isAnswered() {
        return most >= 0;
    }

    /** The same with these shots. */
    public Order shooting(List<Shot> others) {
        return new Order(kind, number, more, others, tolerance, weight, meshError, ambient, givenBack, begun, most,
                least);
    }

    /** The same, naming candidates with so much unshot flux only, W. */
    public Order from(double flux) {
        return new Order(kind, number, more, shots, tolerance, weight, meshError, ambient, givenBack, begun, most,
                flux);
    }

    public byte[] encode() {
        return Wire.bytes(out -> write(out, true));
    }

    /** For who has {@link ShotHistory}: what was shot is left out where it is all that was ever shot. */
    public byte[] encodeShort() {
        return Wire.bytes(out -> write(out, !gathersTotals()));
    }

    private void write(DataOutputStream out, boolean whole) throws IOException {
        out.writeByte(kind.ordinal());
        out.writeInt(number);
        out.writeBoolean(more);
        int channels = shots.isEmpty() ? 0 : shots.get(0).channels();
        if (whole) {
            Wire.write(shots, channels, out);
        } else {
            Wire.writeTrees(shots, channels, out);
        }
        out.writeDouble(tolerance);
        write(weight, out);
        out.writeDouble(meshError);
        write(ambient, out);
        write(givenBack, out);
        out.writeBoolean(begun);
        out.writeInt(most);
        out.writeDouble(least);
    }

    public static Order decode(byte[] bytes) throws IOException {
        return decode(Wire.input(bytes));
    }

    public static Order decode(DataInputStream in) throws IOException {
        Kind kind = kind(in.readByte());
        int number = in.readInt();
        boolean more = in.readBoolean();
        boolean totals = kind == Kind.GATHER || kind == Kind.REGATHER;
        List<Shot> shots = totals ? Wire.trees(in) : Wire.shots(in);
        double tolerance = in.readDouble();
        double[] weight = doubles(in);
        double meshError = in.readDouble();
        double[] ambient = doubles(in);
        double[] givenBack = doubles(in);
        return new Order(kind, number, more, shots, tolerance, weight, meshError, ambient, givenBack,
                in.readBoolean(), in.readInt(), in.readDouble());
    }

    private static void write(double[] numbers, DataOutputStream out) throws IOException {
        out.writeInt(numbers.length);
        for (double number : numbers) {
            out.writeDouble(number);
        }
    }

    private static double[] doubles(DataInputStream in) throws IOException {
        double[] numbers = new double[Wire.count(in, Double.BYTES)];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = in.readDouble();
        }
        return numbers;
    }

    private static Kind kind(int number) throws IOException {
        if (number < 0 || number >= Kind.values().length) {
            throw new IOException("order: expected a kind below " + Kind.values().length + ", got " + number);
        }
        return Kind.values()[number];
    }
}
