package radiosity.viewer;

/** There is no display to open a window on, or it cannot show three dimensions. */
public final class DisplayException extends Exception {

    DisplayException(String message, Throwable cause) {
        super(message, cause);
    }
}
