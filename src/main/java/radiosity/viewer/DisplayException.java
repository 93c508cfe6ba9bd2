package radiosity.viewer;

/** Thrown where there is no display to open a window on, or the display cannot show three dimensions. */
public final class DisplayException extends Exception {

    DisplayException(String message, Throwable cause) {
        super(message, cause);
    }
}
