package radiosity.util;

/** A calculation came to something that is no number, or is too large to be written. */
public final class NoNumberException extends ArithmeticException {

    private static final long serialVersionUID = 1;

    public NoNumberException(String message) {
        super(message);
    }

    /** Lets numbers pass. */
    public static void unlessNumbers(String what, double... values) {
        for (double value : values) {
            if (!Double.isFinite(value)) {
                throw new NoNumberException(what + ": expected numbers, got " + value);
            }
        }
    }
}
