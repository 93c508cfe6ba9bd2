package radiosity.solution;

import radiosity.util.NoNumberException;

/**
 * State of a calculation.
 *
 * @param shots    number of shots done
 * @param rounds   number of rounds begun
 * @param unsent   unshot flux relative to the emitted flux, after the last round whose answer has arrived, which may be
 *                 the one before the round of the last shot; may exceed 1 while light is being gathered
 * @param elements number of elements, those on faces that coincide with others counted, which a solution leaves out
 * @param error    relative error by the latest estimate, see {@link Certificate#expected}; NaN before the first one
 * @param gathers  whether new vertices still gather the light that was shot before they were made, or all vertices
 *                 gather anew; {@code unsent} is then the one before
 */
public record Progress(int shots, int rounds, double unsent, int elements, double error, boolean gathers) {

    /** @throws NoNumberException where the unshot flux is infinite or NaN */
    public Progress {
        NoNumberException.unlessNumbers("unsent flux", unsent);
    }

    /** Progress without an estimate of the error. */
    public Progress(int shots, int rounds, double unsent, int elements, boolean gathers) {
        this(shots, rounds, unsent, elements, Double.NaN, gathers);
    }
}
