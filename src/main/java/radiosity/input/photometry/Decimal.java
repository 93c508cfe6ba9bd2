package radiosity.input.photometry;

import java.util.regex.Pattern;

/** Numbers as photometric files write them. */
final class Decimal {

    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d{1,4})?");

    private Decimal() { }

    /** A finite number; NaN where the text is not a number or too large. */
    static double parse(String text) {
        double value = text.length() < 400 && NUMBER.matcher(text).matches() ? Double.parseDouble(text) : Double.NaN;
        return Double.isInfinite(value) ? Double.NaN : value;
    }
}
