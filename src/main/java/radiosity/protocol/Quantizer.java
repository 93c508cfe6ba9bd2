package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.IOException;
import java.util.function.DoubleUnaryOperator;

/**
 * The units in which the radiosities of a tree are counted, so that each fits into a byte: powers of two, one for each
 * channel of each run of consecutive nodes, so that a dark node keeps its digits beside a bright one.
 *
 * @param unit channels per run of nodes, W/m²; 0 where all radiosities of the run are 0
 */
record Quantizer(int channels, double[] unit) {

    /** Binary digits of the largest radiosity of a run, counted in units: with a sign it fits into a byte. */
    private static final int DIGITS = 7;
    /** Binary logarithm of the number of nodes in a run; four siblings are always in the same run. */
    private static final int RUN = 4;

    /** Units of 0. */
    static Quantizer none(int nodes, int channels) {
        return new Quantizer(channels, new double[channels * ((nodes + 2 >> RUN) + 1)]);
    }

    /** @param radiosity radiosities of a tree, 3 x channels per node, W/m²; not modified */
    static Quantizer of(double[] radiosity, int channels) {
        int perNode = 3 * channels;
        Quantizer units = none(radiosity.length / perNode, channels);
        double[] unit = units.unit;
        for (int node = 0; node < radiosity.length / perNode; node++) {
            int run = units.run(node);
            for (int i = perNode * node; i < perNode * (node + 1); i += channels) {
                for (int c = 0; c < channels; c++) {
                    double size = Math.abs(radiosity[i + c]);
                    unit[run + c] = size > unit[run + c] ? size : unit[run + c];
                }
            }
        }
        for (int i = 0; i < unit.length; i++) {
            unit[i] = unit[i] == 0 ? 0 : unit(unit[i]);
        }
        return units;
    }

    /** The least power of two for which {@code largest} divided by it, rounded up, is at most 127. */
    private static double unit(double largest) {
        double unit = Math.max(Double.MIN_NORMAL, Math.scalb(1.0, Math.getExponent(largest) - DIGITS + 1));
        return Math.ceil(largest / unit) < 1 << DIGITS ? unit : 2 * unit;
    }

    /** Index of the first of a node's units, of which there is one per channel. */
    private int run(int node) {
        return channels * (node + 3 >> RUN);
    }

    double at(int node, int channel) {
        return unit[run(node) + channel];
    }

    /** The radiosities as multiples of the units; {@code rounding} rounds a number of units to a whole number. */
    double[] rounded(double[] radiosity, DoubleUnaryOperator rounding) {
        double[] rounded = new double[radiosity.length];
        int perNode = 3 * channels;
        for (int node = 0; node < radiosity.length / perNode; node++) {
            int run = run(node);
            for (int i = perNode * node; i < perNode * (node + 1); i += channels) {
                for (int c = 0; c < channels; c++) {
                    double u = unit[run + c];
                    rounded[i + c] = u == 0 ? 0 : rounding.applyAsDouble(radiosity[i + c] / u) * u + 0.0;
                }
            }
        }
        return rounded;
    }

    /** Whether all radiosities are whole multiples of the units. */
    boolean fit(double[] radiosity) {
        double[] rounded = rounded(radiosity, Math::rint);
        for (int i = 0; i < rounded.length; i++) {
            if (rounded[i] != radiosity[i]) {
                return false;
            }
        }
        return true;
    }

    void write(DataOutput out) throws IOException {
        for (double u : unit) {
            out.writeShort(Math.getExponent(u));
        }
    }

    static Quantizer read(DataInputStream in, int nodes, int channels) throws IOException {
        Quantizer units = none(nodes, channels);
        if ((long) Short.BYTES * units.unit.length > in.available()) {
            throw new IOException("shot: expected " + units.unit.length + " units, got " + in.available() + " bytes");
        }
        for (int i = 0; i < units.unit.length; i++) {
            int exponent = in.readShort();
            if (exponent < Double.MIN_EXPONENT - 1 || exponent > Double.MAX_EXPONENT) {
                throw new IOException("shot: expected the exponent of a number, got " + exponent);
            }
            units.unit[i] = exponent < Double.MIN_EXPONENT ? 0 : Math.scalb(1.0, exponent);
        }
        return units;
    }
}
