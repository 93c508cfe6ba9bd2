package radiosity.util;

/** Thrown where a computed value is infinite or NaN. */
public final class NoNumberException extends ArithmeticException {

    private static final long serialVersionUID = 1;

    public NoNumberException(String message) {
        super(message);
    }

    /** @throws NoNumberException where one of the values is infinite or NaN */
    public static void unlessNumbers(String what, double... values) {
        for (double value : values) {
            if (!Double.isFinite(value)) {
                throw new NoNumberException(what + ": expected numbers, got " + value);
            }
        }
    }
}
