package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import radiosity.prediction.CoarseSystem;
import radiosity.worker.ShotHistory;

/**
 * What every partition does in a round, or in a part of one.
 *
 * @param kind     what it is
 * @param number   counts the rounds of a calculation from 1
 * @param begun    whether a part of the round is done: the ambient light has been received
 * @param more     whether the rest of the round follows
 * @param shots    who shoots, in the order in which it is applied
 * @param rules    how points gather and elements are divided
 * @param question what partitions answer
 */
public record Order(Kind kind, int number, boolean begun, boolean more, List<Shot> shots, Rules rules,
                    Question question) {

    private static final double[] NONE = {};
    /** What stands for a question without candidates where their number is written. */
    private static final int NOTHING = -1;
    private static final int GHOST_VALUES = -2;

    /**
     * How points gather and elements are divided.
     *
     * @param tolerance how much one ray may carry, see {@link radiosity.formfactor.RayCaster}
     * @param weight    what a W/m² counts for in that, see {@link radiosity.mesh.Weights}
     * @param meshError how much interpolation on one element may add to the error of the whole, relative to its mean
     * @param ambient   channels per closed room, see {@link radiosity.mesh.UniformRadiosity}; empty: none. W/m²
     * @param givenBack one per channel, or empty: part of what each vertex has received that it receives besides
     * @param sparing   whether what carries little gets a ray at some points only, see
     *                  {@link radiosity.formfactor.RayCaster}; rays are others then than in all other rounds
     * @param anew      weight, in (0, 1], of the light that was gathered anew where it is averaged with older light
     */
    public record Rules(double tolerance, double[] weight, double meshError, double[] ambient, double[] givenBack,
                        boolean sparing, double anew) {

        /** A ray for each shooter at every point. */
        public Rules(double tolerance, double[] weight, double meshError, double[] ambient, double[] givenBack) {
            this(tolerance, weight, meshError, ambient, givenBack, false, 1);
        }

        private static final Rules UNUSED = new Rules(0, NONE, 0, NONE, NONE);

        /** Every shooter by its own form factors, all channels alike: the paper's schedule. */
        public static Rules exact(int channels) {
            double[] weight = new double[channels];
            Arrays.fill(weight, 1);
            return new Rules(Double.POSITIVE_INFINITY, weight, 0, NONE, NONE);
        }

        /** The same rules, and all receive this part of what they have besides. */
        Rules givingBack(double[] part) {
            return new Rules(tolerance, weight, meshError, ambient, part, sparing, anew);
        }
    }

    /** What partitions answer to an order. */
    public sealed interface Question {

        /** Nobody reads the answer. */
        record Nothing() implements Question { }

        /**
         * Gather only where other hosts need it, and say what has arrived there; elsewhere points gather by {@link
         * Kind#REST}.
         */
        record GhostValues() implements Question { }

        /**
         * Name candidates for the next round.
         *
         * @param most how many, at least 0
         * @param flux unshot flux that a candidate has at least, W
         */
        record Candidates(int most, double flux) implements Question { }

        Question NOTHING = new Nothing();
        Question GHOST_VALUES = new GhostValues();

        /** Name candidates, however little flux they have. */
        static Question candidates(int most) {
            return new Candidates(most, 0);
        }
    }

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
        /** Give all vertices back what rays have lost, see {@link Rules#givenBack}. */
        BALANCE,
        /** Say what was ever shot. */
        TOTALS,
        /** Say what is unshot, rounded toward zero; no corner is to have shot less than nothing. */
        UNSHOT,
        /** Say how all trees are divided. */
        TREES,
        /** Say who could shoot, on the patches of the coarse mesh: their means. */
        MEANS,
        /** Say, for the coarse mesh's vertices, how much of each patch they see: rows of a {@link CoarseSystem}. */
        ROWS,
        /** Gather where an order for {@link Question.GhostValues} has not: where no other host needs it. */
        REST,
        /** Gather anew, of all that was ever shot, at vertices that have received less than nothing. In one step. */
        MEND;

        /** Whether points gather all that was ever shot: hosts know it, and are not sent it. */
        boolean gathersTotals() {
            return this == GATHER || this == REGATHER || this == MEND;
        }
    }

    /** A round that is not begun yet; it gets its number when it is. */
    public Order(Kind kind, List<Shot> shots, Rules rules, Question question) {
        this(kind, 0, false, false, shots, rules, question);
    }

    /** An order without shots. */
    public static Order plain(Kind kind, Question question) {
        return new Order(kind, List.of(), Rules.UNUSED, question);
    }

    /** An order without shots that names candidates, or answers something else. */
    public static Order asking(Kind kind, int most) {
        return plain(kind, Question.candidates(most));
    }

    /** The same order as a round of its own. @param lost is given back: one per channel, or empty */
    public Order numbered(int round, double[] lost) {
        return new Order(kind, round, begun, more, shots, rules.givingBack(lost), question);
    }

    /** The first shots of this round; candidates are named when it ends. */
    public Order first(int size) {
        boolean all = size == shots.size();
        return new Order(kind, number, begun, !all, shots.subList(0, size), rules,
                all || !(question instanceof Question.Candidates asked) ? question
                        : new Question.Candidates(0, asked.flux));
    }

    /** What is left of this round without its first shots. */
    public Order after(int size) {
        return new Order(kind, number, true, more, shots.subList(size, shots.size()), rules, question);
    }

    /** All of it, in parts of up to this number of shots. */
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
        return kind.gathersTotals();
    }

    /** Whether what is shot counts as shot from now on. */
    public boolean marks() {
        return kind == Kind.SHOOT || kind == Kind.RENEW;
    }

    /** The same order with another question. */
    public Order asking(Question other) {
        return new Order(kind, number, begun, more, shots, rules, other);
    }

    /** The same order with other shots. */
    public Order shooting(List<Shot> others) {
        return new Order(kind, number, begun, more, others, rules, question);
    }

    /** Whether the state of the elements is asked for. */
    public boolean isAnswered() {
        return question instanceof Question.Candidates;
    }

    /** Whether points gather only where other hosts need it. */
    public boolean givesGhosts() {
        return question instanceof Question.GhostValues;
    }

    /** How many candidates to name. */
    public int most() {
        return question instanceof Question.Candidates asked ? asked.most : 0;
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
        out.writeDouble(rules.tolerance);
        write(rules.weight, out);
        out.writeDouble(rules.meshError);
        write(rules.ambient, out);
        write(rules.givenBack, out);
        out.writeBoolean(rules.sparing);
        out.writeDouble(rules.anew);
        out.writeBoolean(begun);
        out.writeInt(isAnswered() ? most() : givesGhosts() ? GHOST_VALUES : NOTHING);
        out.writeDouble(question instanceof Question.Candidates asked ? asked.flux : 0);
    }

    public static Order decode(byte[] bytes) throws IOException {
        return decode(Wire.input(bytes));
    }

    public static Order decode(DataInputStream in) throws IOException {
        Kind kind = kind(in.readByte());
        int number = in.readInt();
        boolean more = in.readBoolean();
        List<Shot> shots = kind.gathersTotals() ? Wire.trees(in) : Wire.shots(in);
        Rules rules = new Rules(in.readDouble(), doubles(in), in.readDouble(), doubles(in), doubles(in),
                in.readBoolean(), in.readDouble());
        return new Order(kind, number, in.readBoolean(), more, shots, rules, question(in));
    }

    private static Question question(DataInputStream in) throws IOException {
        int most = in.readInt();
        double flux = in.readDouble();
        if (most < GHOST_VALUES) {
            throw new IOException("order: expected a number of candidates, got " + most);
        }
        return most == NOTHING ? Question.NOTHING : most == GHOST_VALUES ? Question.GHOST_VALUES
                : new Question.Candidates(most, flux);
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
