package radiosity.input.photometry;

import java.util.regex.Pattern;

/** Numbers as luminaires' files write them. */
final class Decimal {

    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d{1,4})?");

    private Decimal() { }

    /** A finite number, or not a number where the text is none. */
    static double parse(String text) {
        double value = text.length() < 400 && NUMBER.matcher(text).matches() ? Double.parseDouble(text) : Double.NaN;
        return Double.isInfinite(value) ? Double.NaN : value;
    }
}
