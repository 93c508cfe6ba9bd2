package radiosity.cli.options;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.function.DoublePredicate;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** The kinds of value that options take: each says what it expects. */
public final class Values {

    private static final int MOST_PORT = 65535;

    private Values() { }

    /** A value that says what it expects, so that a wrong one and a missing one get the same words. */
    public abstract static class Value<T> implements ITypeConverter<T> {

        /** What may stand here, after "expected". */
        abstract String expected();

        /** The value, or null where the text is none. */
        public abstract T parse(String text);

        /** What may be meant by a text that is no value, to stand behind the message; empty: not known. */
        String instead(String text) {
            return "";
        }

        @Override
        public final T convert(String text) {
            T value = parse(text);
            if (value == null) {
                throw new TypeConversionException("expected " + expected() + ", got " + shown(text) + instead(text));
            }
            return value;
        }
    }

    private static String shown(String text) {
        return text.isBlank() ? "nothing" : text.strip();
    }

    /** A finite decimal number, or NaN where the text is none; "NaN", "1d" and "0x1" are none. */
    static double decimal(String text) {
        try {
            double value = new BigDecimal(text).doubleValue();
            return Double.isInfinite(value) ? Double.NaN : value;
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    /** A whole number in [least, most], or null. */
    static Integer whole(String text, int least, int most) {
        try {
            int value = Integer.parseInt(text);
            return value >= least && value <= most ? value : null;
        } catch (NumberFormatException e) {
            return null;
        }
    }

    /** A finite decimal number of some kind. */
    abstract static class Decimal extends Value<Double> {

        private final String expected;
        private final DoublePredicate fits;

        Decimal(String expected, DoublePredicate fits) {
            this.expected = expected;
            this.fits = fits;
        }

        @Override
        final String expected() {
            return expected;
        }

        @Override
        public final Double parse(String text) {
            double value = decimal(text);
            return !Double.isNaN(value) && fits.test(value) ? value : null;
        }
    }

    /** Any finite number. */
    static final class AnyNumber extends Decimal {
        AnyNumber() {
            super("a number", x -> true);
        }
    }

    /** A number above 0. */
    static final class Positive extends Decimal {
        Positive() {
            super("a number above 0", x -> x > 0);
        }
    }

    /** A number of at least 0. */
    static final class NotNegative extends Decimal {
        NotNegative() {
            super("a number of at least 0", x -> x >= 0);
        }
    }

    /** A part of a whole. */
    static final class Part extends Decimal {
        Part() {
            super("a number from 0 to 1", x -> x >= 0 && x <= 1);
        }
    }

    /** A whole number in a range. */
    abstract static class Whole extends Value<Integer> {

        private final String expected;
        private final int least;
        private final int most;

        Whole(String expected, int least, int most) {
            this.expected = expected;
            this.least = least;
            this.most = most;
        }

        @Override
        final String expected() {
            return expected;
        }

        @Override
        public final Integer parse(String text) {
            return whole(text, least, most);
        }
    }

    /** A count that may be 0. */
    static final class Count extends Whole {
        Count() {
            super("a whole number of at least 0", 0, Integer.MAX_VALUE - 1);
        }
    }

    /** A count of at least one. */
    static final class AtLeastOne extends Whole {
        AtLeastOne() {
            super("a whole number of at least 1", 1, Integer.MAX_VALUE - 1);
        }
    }

    /** A number of a TCP port. */
    static final class Port extends Whole {
        Port() {
            super("a port from 1 to " + MOST_PORT, 1, MOST_PORT);
        }
    }

    /** A number of a TCP port, or 0 for any. */
    static final class AnyPort extends Whole {
        AnyPort() {
            super("a port from 0 to " + MOST_PORT, 0, MOST_PORT);
        }
    }

    /** {@code 2%} or {@code 0.02}, above 0 and at most 100 %; as a part of 1, below 0.1 where there is no sign. */
    public static final class PerCent extends Value<Double> {

        private static final double DOUBTFUL = 0.1;

        @Override
        String expected() {
            return "per cent above 0 and up to 100, like 2%";
        }

        @Override
        public Double parse(String text) {
            boolean hundredths = text.endsWith("%");
            double value = decimal(hundredths ? text.substring(0, text.length() - 1) : text) / (hundredths ? 100 : 1);
            return value > 0 && value <= 1 && (hundredths || value < DOUBTFUL) ? value : null;
        }

        /** A number without a sign that may be either. */
        @Override
        String instead(String text) {
            double value = decimal(text);
            return value >= DOUBTFUL && value <= 100
                    ? "; " + text + "% or " + new BigDecimal(text).movePointLeft(2).toPlainString() + "?" : "";
        }
    }

    /** One of an enum's constants, written in small letters. */
    public abstract static class Choice<E extends Enum<E>> extends Value<E> {

        private final E[] constants;

        Choice(Class<E> type) {
            constants = type.getEnumConstants();
        }

        @Override
        String expected() {
            StringBuilder names = new StringBuilder();
            for (int i = 0; i < constants.length; i++) {
                names.append(i == 0 ? "" : i == constants.length - 1 ? " or " : ", ").append(name(constants[i]));
            }
            return names.toString();
        }

        @Override
        public E parse(String text) {
            for (E constant : constants) {
                if (name(constant).equals(text)) {
                    return constant;
                }
            }
            return null;
        }

        private String name(E constant) {
            return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
        }
    }
}
