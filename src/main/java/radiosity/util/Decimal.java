package radiosity.util;

/** Decimal numbers as users and files write them: no NaN, no hexadecimal numbers, no letters after a number. */
public final class Decimal {

    private static final String SIGNS = "+-.eE";

    private Decimal() { }

    /** The finite decimal number that a text is; NaN where the text is something else or the number is too large. */
    public static double parse(String text) {
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if ((c < '0' || c > '9') && SIGNS.indexOf(c) < 0) {
                return Double.NaN;
            }
        }
        try {
            double value = Double.parseDouble(text);
            return Double.isInfinite(value) ? Double.NaN : value;
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }
}
