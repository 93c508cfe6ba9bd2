package radiosity.util;

/** Something that has more numbers than an array can hold; the message says in one line what, and how many. */
public final class TooLargeException extends RuntimeException {

    private static final long serialVersionUID = 1;

    TooLargeException(String message) {
        super(message);
    }
}
