package radiosity.testkit;

import static org.junit.jupiter.api.Assertions.assertTrue;

/**
 * An error that was measured, and what it may be.
 *
 * @param what    of what it is the error
 * @param asked   the most that it may be
 * @param reached what it is
 */
public record Figure(String what, double asked, double reached) {

    /** Of which nothing is asked. */
    public static Figure told(String what, double reached) {
        return new Figure(what, Double.POSITIVE_INFINITY, reached);
    }

    /** An absolute value's distance from what it must be. */
    public static Figure of(String what, double asked, double exact, double found) {
        return new Figure(what, asked, Math.abs(found - exact));
    }

    /** Relative to what it must be. */
    public static Figure relative(String what, double asked, double exact, double found) {
        return of(what, asked, 1, found / exact);
    }

    /** Relative or absolute, whichever leaves more room; counted as a relative one. */
    public static Figure relative(String what, double asked, double orAbsolute, double exact, double found) {
        return new Figure(what, asked, asked * Math.abs(found - exact) / Math.max(asked * exact, orAbsolute));
    }

    /** False too where what was reached is no number. */
    public boolean holds() {
        return reached <= asked;
    }

    void check(String of) {
        assertTrue(holds(), () -> of + ", " + what + ": expected at most " + asked + ", got " + reached);
    }
}
