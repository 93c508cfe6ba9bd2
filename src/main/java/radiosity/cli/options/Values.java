package radiosity.cli.options;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.function.DoublePredicate;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import radiosity.settings.RadiositySettings;

/** The kinds of values of options. */
public final class Values {

    private static final int MOST_PORT = 65535;

    private Values() { }

    /** A kind of value with a description, so that messages about wrong and about missing values use the same words. */
    public abstract static class Value<T> implements ITypeConverter<T> {

        /** Description of the allowed values, to follow "expected" in a message. */
        abstract String expected();

        /** The value of a text; null where the text is no value of this kind. */
        public abstract T parse(String text);

        /** Suggests what a text that is no value may mean, to be appended to the message; empty: no suggestion. */
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

    /** The finite decimal number in a text; NaN where there is none, as in "NaN", "1d" and "0x1". */
    static double decimal(String text) {
        return radiosity.util.Decimal.parse(text);
    }

    /** The whole number in a text; null where there is none or it is not in [least, most]. */
    static Integer whole(String text, int least, int most) {
        try {
            int value = Integer.parseInt(text);
            return value >= least && value <= most ? value : null;
        } catch (NumberFormatException e) {
            return null;
        }
    }

    /** A finite decimal number that satisfies a condition. */
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

    /** A part of a whole, in [0, 1]. */
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

    /** A number of rays at a node. */
    static final class Rays extends Whole {
        Rays() {
            super("a whole number from 1 to " + RadiositySettings.MOST_RAYS, 1, RadiositySettings.MOST_RAYS);
        }
    }

    /** The number of a TCP port. */
    static final class Port extends Whole {
        Port() {
            super("a port from 1 to " + MOST_PORT, 1, MOST_PORT);
        }
    }

    /** The number of a TCP port, or 0 for any port. */
    static final class AnyPort extends Whole {
        AnyPort() {
            super("a port from 0 to " + MOST_PORT, 0, MOST_PORT);
        }
    }

    /** Name or address of a host, without a port. */
    static final class HostName extends Value<String> {

        private static final Pattern NAME = Pattern.compile("[\\p{L}\\d_.-]+|[\\da-fA-F:.]+(%\\w+)?");

        @Override
        String expected() {
            return "a host's name or address";
        }

        @Override
        public String parse(String text) {
            return NAME.matcher(text).matches() && !text.startsWith("-") ? text : null;
        }
    }

    /**
     * A percentage above 0 and at most 100 %, converted to a part of 1: {@code 2%} or {@code 0.02}. A number without a
     * per cent sign must be below 0.1, as its meaning would be in doubt otherwise.
     */
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

        /** Suggests both meanings of a number without a per cent sign. */
        @Override
        String instead(String text) {
            double value = decimal(text);
            return value >= DOUBTFUL && value <= 100
                    ? "; " + text + "% or " + new BigDecimal(text).movePointLeft(2).toPlainString() + "?" : "";
        }
    }

    /** One of an enum's constants, written in lower case with hyphens. */
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
