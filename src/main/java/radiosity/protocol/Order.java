package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * An order that every partition carries out in a round, or in a part of a round.
 *
 * @param kind     kind of the round
 * @param number   number of the round in the calculation, from 1; 0 before the round has begun
 * @param begun    whether an earlier part of the round is done, in which vertices have received the ambient light
 * @param more     whether more parts of the round follow
 * @param shots    light of the shooters, in the order in which it is gathered
 * @param rules    how vertices gather and elements are divided
 * @param question what partitions answer
 */
public record Order(Kind kind, int number, boolean begun, boolean more, List<Shot> shots, Rules rules,
                    Question question) {

    private static final double[] NONE = {};
    /** Values written in place of the number of candidates, for questions that ask for none. */
    private static final int NOTHING = -1;
    private static final int GHOST_VALUES = -2;
    private static final int IRRADIANCE = -3;

    /**
     * How vertices gather and elements are divided.
     *
     * @param tolerance largest weighted irradiance that one ray may carry, see {@link radiosity.formfactor.RayCaster};
     *                  infinite: no limit
     * @param weight    weight of a W/m² of each channel, m²/W, see {@link radiosity.mesh.Weights}
     * @param meshError error that interpolation on one element may add to the whole, relative to the mean radiosity
     * @param ambient   channels per closed room, W/m², see {@link radiosity.mesh.UniformRadiosity}; empty: 0
     * @param givenBack one per channel: part of its irradiance by which each vertex's irradiance grows; empty: 0
     * @param sparing   whether a shooter that carries little gets a ray at some vertices only, see
     *                  {@link radiosity.formfactor.RayCaster#sparing}; the rays are then not those of any other round
     * @param anew      weight in (0, 1] of the newly gathered light in its average with older light
     * @param marks     nodes that are divided even where their vertices show no error
     */
    public record Rules(double tolerance, double[] weight, double meshError, double[] ambient, double[] givenBack,
                        boolean sparing, double anew, List<Mark> marks) {

        /** Rules under which every vertex casts a ray to every shooter. */
        public Rules(double tolerance, double[] weight, double meshError, double[] ambient) {
            this(tolerance, weight, meshError, ambient, NONE, false, 1, List.of());
        }

        /** Rules under which every vertex casts a ray to every shooter, without ambient light. */
        public Rules(double tolerance, double[] weight, double meshError) {
            this(tolerance, weight, meshError, NONE);
        }

        private static final Rules UNUSED = new Rules(0, NONE, 0);

        /** Rules of the paper's schedule: each shooter by its own form factors, all channels with the same weight. */
        public static Rules exact(int channels) {
            double[] weight = new double[channels];
            Arrays.fill(weight, 1);
            return new Rules(Double.POSITIVE_INFINITY, weight, 0);
        }

        /** These rules with other {@link #marks}. */
        Rules dividing(List<Mark> nodes) {
            return new Rules(tolerance, weight, meshError, ambient, givenBack, sparing, anew, nodes);
        }

        /** These rules with another {@link #givenBack}. */
        Rules givingBack(double[] part) {
            return new Rules(tolerance, weight, meshError, ambient, part, sparing, anew, marks);
        }
    }

    /** The question that partitions answer when they have carried out an order. */
    public sealed interface Question {

        /** No answer is read. */
        record Nothing() implements Question { }

        /**
         * Gather only at vertices whose irradiance other hosts need, and answer that irradiance; the other vertices
         * gather by an order of {@link Kind#REST}.
         */
        record GhostValues() implements Question { }

        /**
         * Name candidates for the next round.
         *
         * @param most largest number of candidates, at least 0
         * @param flux least unshot flux of a candidate, W
         */
        record Candidates(int most, double flux) implements Question { }

        /** Answer the irradiance at some points, see {@link Kind#GATHER_AT}. */
        record Irradiance(GatherPoints points) implements Question { }

        Question NOTHING = new Nothing();
        Question GHOST_VALUES = new GhostValues();

        /** Name up to {@code most} candidates, however little flux they have. */
        static Question candidates(int most) {
            return new Candidates(most, 0);
        }
    }

    /** The kinds of round. "Mark" means: count the radiosity of the shots as shot on the elements that shoot it. */
    public enum Kind {
        /** Change nothing; only answer the question. */
        ASK,
        /** Mark the shots, gather at every vertex; at the end subdivide by the paper's rule if that is on. */
        SHOOT,
        /** Subdivide where the error of interpolation is too large; new vertices have gathered nothing yet. */
        SPLIT,
        /** Gather at the vertices that the previous round has made; mark nothing. */
        GATHER,
        /** Mark the shots, and set aside the irradiance of all vertices, which have gathered nothing then. */
        RENEW,
        /** Gather at all vertices all light that was ever shot, along other rays than before; mark nothing. */
        REGATHER,
        /** Average the newly gathered irradiance with the one set aside, except where the latter is negative. */
        AVERAGE,
        /** Increase the irradiance of all vertices by the part that rays have lost, see {@link Rules#givenBack}. */
        BALANCE,
        /** Answer the radiosity that each shooter has shot in total. */
        TOTALS,
        /** Answer the unshot radiosity, rounded up, with which the total shot at each corner becomes 0 or more. */
        UNSHOT,
        /** Answer the trees of all shooters without radiosities. */
        TREES,
        /** As {@link #ASK}, but each candidate has its mean radiosities over the patches of the coarse mesh. */
        MEANS,
        /** Answer how much each vertex of the coarse mesh sees of each patch: rows of a {@code CoarseSystem}. */
        ROWS,
        /** Gather where the last order for {@link Question.GhostValues} did not: at vertices that no other host has. */
        REST,
        /** At vertices of negative irradiance, gather all light ever shot anew; not to be cut into parts. */
        MEND,
        /** Answer the irradiance that the shots alone cause at the points of the question, for an estimate. */
        GATHER_AT;

        /** Whether vertices gather all light that was ever shot: hosts have it, so the master does not send it. */
        public boolean gathersTotals() {
            return this == GATHER || this == REGATHER || this == MEND;
        }
    }

    /** An order for a round that has not begun; {@link #numbered} gives the round its number. */
    public Order(Kind kind, List<Shot> shots, Rules rules, Question question) {
        this(kind, 0, false, false, shots, rules, question);
    }

    /** An order without shots, of a kind that needs no rules. */
    public static Order plain(Kind kind, Question question) {
        return new Order(kind, List.of(), Rules.UNUSED, question);
    }

    /** An order without shots, for up to {@code most} candidates or for the answer that its kind defines. */
    public static Order asking(Kind kind, int most) {
        return plain(kind, Question.candidates(most));
    }

    /** This order with {@link Rules#marks}. */
    public Order dividing(List<Mark> marks) {
        return new Order(kind, number, begun, more, shots, rules.dividing(marks), question);
    }

    /** This order with {@link Rules#givenBack}. */
    public Order givingBack(double[] part) {
        return new Order(kind, number, begun, more, shots, rules.givingBack(part), question);
    }

    /** This order as round number {@code round}. */
    public Order numbered(int round) {
        return new Order(kind, round, begun, more, shots, rules, question);
    }

    /** The part of this order with its first shots; only the last part of a round asks for candidates. */
    public Order first(int size) {
        boolean all = size == shots.size();
        return new Order(kind, number, begun, !all, shots.subList(0, size), rules,
                all || !(question instanceof Question.Candidates asked) ? question
                        : new Question.Candidates(0, asked.flux));
    }

    /** The part of this order that follows its first shots. */
    public Order after(int size) {
        return new Order(kind, number, true, more, shots.subList(size, shots.size()), rules, question);
    }

    /** All of this order, in parts of up to {@code size} shots. */
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

    /** Whether the order changes elements, so that it must be carried out again on a block that was lost. */
    public boolean changes() {
        return gathers() || kind == Kind.SPLIT || kind == Kind.RENEW || kind == Kind.AVERAGE
                || kind == Kind.BALANCE;
    }

    public boolean gathers() {
        return kind == Kind.SHOOT || kind.gathersTotals();
    }

    /** Whether the radiosity of the shots counts as shot afterwards. */
    public boolean marks() {
        return kind == Kind.SHOOT || kind == Kind.RENEW;
    }

    /** This order with another question. */
    public Order asking(Question other) {
        return new Order(kind, number, begun, more, shots, rules, other);
    }

    /** This order with other shots. */
    public Order shooting(List<Shot> others) {
        return new Order(kind, number, begun, more, others, rules, question);
    }

    /** Whether an answer to the order is read. */
    public boolean isAnswered() {
        return question instanceof Question.Candidates || question instanceof Question.Irradiance;
    }

    /** Whether vertices gather only where other hosts need the irradiance. */
    public boolean givesGhosts() {
        return question instanceof Question.GhostValues;
    }

    /** Largest number of candidates to name; 0 where the question asks for none. */
    public int most() {
        return question instanceof Question.Candidates asked ? asked.most : 0;
    }

    public byte[] encode() {
        return Wire.bytes(out -> write(out, true));
    }

    /** For receivers that keep a {@code ShotHistory}: without radiosities where the shots are all light ever shot. */
    public byte[] encodeShort() {
        return Wire.bytes(out -> write(out, !kind.gathersTotals()));
    }

    private void write(DataOutputStream out, boolean whole) throws IOException {
        out.writeByte(kind.ordinal());
        out.writeInt(number);
        out.writeBoolean(more);
        int channels = shots.isEmpty() ? 0 : shots.get(0).channels();
        Wire.write(whole ? shots : shots.stream().map(Shot::withoutRadiosities).toList(), channels, out);
        out.writeDouble(rules.tolerance);
        Wire.writeDoubles(out, rules.weight);
        out.writeDouble(rules.meshError);
        Wire.writeDoubles(out, rules.ambient);
        Wire.writeDoubles(out, rules.givenBack);
        out.writeBoolean(rules.sparing);
        out.writeDouble(rules.anew);
        Wire.writeMarks(out, rules.marks);
        out.writeBoolean(begun);
        if (question instanceof Question.Candidates asked) {
            out.writeInt(asked.most);
            out.writeDouble(asked.flux);
        } else if (question instanceof Question.Irradiance asked) {
            out.writeInt(IRRADIANCE);
            asked.points.write(out);
        } else {
            out.writeInt(givesGhosts() ? GHOST_VALUES : NOTHING);
        }
    }

    public static Order decode(byte[] bytes) throws IOException {
        return decode(Wire.input(bytes));
    }

    public static Order decode(DataInputStream in) throws IOException {
        Kind kind = kind(in.readByte());
        int number = in.readInt();
        boolean more = in.readBoolean();
        List<Shot> shots = kind.gathersTotals() ? Wire.trees(in) : Wire.shots(in);
        Rules rules = new Rules(in.readDouble(), Wire.readDoubles(in), in.readDouble(), Wire.readDoubles(in),
                Wire.readDoubles(in), in.readBoolean(), in.readDouble(), Wire.readMarks(in));
        return new Order(kind, number, in.readBoolean(), more, shots, rules, question(in));
    }

    private static Question question(DataInputStream in) throws IOException {
        int most = in.readInt();
        if (most < IRRADIANCE) {
            throw new IOException("order: expected a number of candidates, got " + most);
        }
        return switch (most) {
            case NOTHING -> Question.NOTHING;
            case GHOST_VALUES -> Question.GHOST_VALUES;
            case IRRADIANCE -> new Question.Irradiance(GatherPoints.read(in));
            default -> new Question.Candidates(most, in.readDouble());
        };
    }

    private static Kind kind(int number) throws IOException {
        if (number < 0 || number >= Kind.values().length) {
            throw new IOException("order: expected a kind below " + Kind.values().length + ", got " + number);
        }
        return Kind.values()[number];
    }
}
