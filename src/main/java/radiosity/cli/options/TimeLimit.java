package radiosity.cli.options;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Wall time that a render may take ({@code --time}).
 *
 * @param text    as the user wrote it
 * @param seconds above 0; counted from the start of the process
 */
public record TimeLimit(String text, double seconds) {

    public static final String OPTION = "--time";
    static final String ESTIMATES = "--estimates";
    private static final String ACCURACY = "--accuracy";
    private static final String SCHEDULE = "--schedule";
    private static final String ITERATIONS = "-it";
    private static final MathContext DIGITS = new MathContext(3, RoundingMode.CEILING);

    /** Lengths of the units in seconds; a number without a unit is in seconds. */
    private static final Map<String,
            Double> UNITS = Map.of("", 1.0, "ms", 1e-3, "s", 1.0, "m", 60.0, "min", 60.0, "h", 3600.0);

    /**
     * An accuracy as {@code --accuracy} reads it, rounded up to three digits.
     *
     * @param accuracy a relative error, above 0
     */
    public static String perCent(double accuracy) {
        return BigDecimal.valueOf(100 * accuracy).round(DIGITS).stripTrailingZeros().toPlainString() + "%";
    }

    /**
     * The options that reproduce, to the last bit, a calculation that reached an accuracy.
     *
     * @param accuracy value of {@code --accuracy}, as for the other methods
     */
    public static List<String> accuracy(String accuracy) {
        return List.of(ACCURACY, accuracy);
    }

    /**
     * The options that reproduce, to the last bit, a calculation after an estimate of its error.
     *
     * @param estimates number of estimates, with that one
     */
    public static List<String> estimates(String accuracy, int estimates) {
        return List.of(ACCURACY, accuracy, ESTIMATES, Integer.toString(estimates));
    }

    /**
     * The options that reproduce, to the last bit, a calculation that a time limit cut off before the first estimate.
     *
     * @param shots number of shots of the calculation
     */
    public static List<String> cutOff(String accuracy, int shots) {
        return List.of(SCHEDULE, "predict", ACCURACY, accuracy, ITERATIONS, Integer.toString(shots));
    }

    /**
     * The command line that reproduces the result of a command line with a time limit: options take the place of the
     * time limit, and replace the same options elsewhere.
     *
     * @param arguments command line with the time limit; not modified
     * @param options   names and values, as the other methods return them
     */
    public static List<String> reproducing(List<String> arguments, List<String> options) {
        List<String> same = new ArrayList<>();
        for (int i = 0; i < arguments.size(); i++) {
            String option = arguments.get(i).replaceFirst("=.*", "");
            boolean isTime = option.equals(OPTION);
            if (isTime) {
                same.addAll(options);
            }
            if (!isTime && !options.contains(option.equals("--iterations") ? ITERATIONS : option)) {
                same.add(arguments.get(i));
            } else if (option.equals(arguments.get(i))) {
                i++; // skips the option's value
            }
        }
        return same;
    }

    /** Parses {@code 60s}, {@code 1ms}, {@code 2m}, {@code 1.5h} and numbers without a unit, which are seconds. */
    public static final class Parser extends Values.Value<TimeLimit> {
        @Override
        String expected() {
            return "a time above 0 like 60s, 500ms, 2m or 1h";
        }

        @Override
        public TimeLimit parse(String text) {
            String unit = text.replaceFirst("^[-+.0-9]*", "");
            double seconds = Values.decimal(text.substring(0, text.length() - unit.length()))
                    * UNITS.getOrDefault(unit, Double.NaN);
            return seconds > 0 ? new TimeLimit(text, seconds) : null;
        }
    }
}
