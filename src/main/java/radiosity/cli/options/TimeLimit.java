package radiosity.cli.options;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Wall time that a render may take ({@code --time}).
 *
 * @param text    as the user wrote it
 * @param seconds above 0; counted from the start of the process
 */
public record TimeLimit(String text, double seconds) {

    public static final String OPTION = "--time";
    private static final String ACCURACY = "--accuracy";
    /** Options that the options of {@link #cutOff} replace. */
    private static final Set<String> REPLACED = Set.of(OPTION, ACCURACY, "--schedule", "-it", "--iterations");
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
     * The options that reproduce, to the last bit, a calculation that a time limit cut off.
     *
     * @param accuracy value of {@code --accuracy}
     * @param shots    number of shots of the calculation
     */
    public static List<String> cutOff(String accuracy, int shots) {
        return List.of("--schedule", "predict", ACCURACY, accuracy, "-it", Integer.toString(shots));
    }

    /**
     * The command line that reproduces a calculation that a time limit cut off, see {@link #cutOff}.
     *
     * @param arguments command line with the time limit; not modified
     */
    public static List<String> reproducing(List<String> arguments, String accuracy, int shots) {
        List<String> same = new ArrayList<>(cutOff(accuracy, shots));
        for (int i = 0; i < arguments.size(); i++) {
            String option = arguments.get(i).replaceFirst("=.*", "");
            if (!REPLACED.contains(option)) {
                same.add(arguments.get(i));
            } else if (option.equals(arguments.get(i))) {
                i++; // skips the option's value
            }
        }
        return same;
    }

    /**
     * The command line that reproduces, to the last bit, the result of a command line with a time limit.
     *
     * @param arguments command line with the time limit; not modified
     * @param accuracy  value of {@code --accuracy} that replaces the time limit
     */
    public static List<String> reproducing(List<String> arguments, String accuracy) {
        List<String> same = new ArrayList<>(arguments);
        for (int i = 0; i < same.size(); i++) {
            if (same.get(i).startsWith(OPTION + "=")) {
                same.set(i, ACCURACY + "=" + accuracy);
            } else if (same.get(i).equals(OPTION) && i + 1 < same.size()) {
                same.set(i, ACCURACY);
                same.set(i + 1, accuracy);
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
