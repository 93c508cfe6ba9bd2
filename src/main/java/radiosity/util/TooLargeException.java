package radiosity.util;

/** Thrown where an array cannot hold the numbers that are needed; the message says their content and count. */
public final class TooLargeException extends IllegalArgumentException {

    private static final long serialVersionUID = 1;

    TooLargeException(String message) {
        super(message);
    }
}
