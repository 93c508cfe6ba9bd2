package radiosity.cli.options;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * How long a render may take ({@code --time}).
 *
 * @param text    as the user wrote it
 * @param seconds above 0, of wall time since the process began
 */
public record TimeLimit(String text, double seconds) {

    public static final String OPTION = "--time";
    private static final String ACCURACY = "--accuracy";
    /** Options that {@link #cutOff} stands for. */
    private static final Set<String> REPLACED = Set.of(OPTION, ACCURACY, "--schedule", "-it", "--iterations");
    private static final MathContext DIGITS = new MathContext(3, RoundingMode.CEILING);

    /** Seconds that the units have; none is seconds. */
    private static final Map<String,
            Double> UNITS = Map.of("", 1.0, "ms", 1e-3, "s", 1.0, "m", 60.0, "min", 60.0, "h", 3600.0);

    /** An accuracy as {@code --accuracy} reads it: three digits, not finer than the given part of 1. */
    public static String perCent(double accuracy) {
        return BigDecimal.valueOf(100 * accuracy).round(DIGITS).stripTrailingZeros().toPlainString() + "%";
    }

    /** The options that give to the last bit what a time limit has cut off after a number of shots. */
    public static List<String> cutOff(String accuracy, int shots) {
        return List.of("--schedule", "predict", ACCURACY, accuracy, "-it", Integer.toString(shots));
    }

    /** The command line that gives to the last bit what a time limit has cut off after a number of shots. */
    public static List<String> reproducing(List<String> arguments, String accuracy, int shots) {
        List<String> same = new ArrayList<>(cutOff(accuracy, shots));
        for (int i = 0; i < arguments.size(); i++) {
            String option = arguments.get(i).replaceFirst("=.*", "");
            if (!REPLACED.contains(option)) {
                same.add(arguments.get(i));
            } else if (option.equals(arguments.get(i))) {
                i++; // its value
            }
        }
        return same;
    }

    /** The command line that gives to the last bit what came of one with a time limit. */
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

    /** Reads {@code 60s}, {@code 1ms}, {@code 2m}, {@code 1.5h} and plain seconds. */
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
