package radiosity.solution;

import radiosity.util.NoNumberException;

/**
 * Where a calculation stands.
 *
 * @param shots    patches that have shot
 * @param rounds   rounds in which they did
 * @param unsent   unshot flux relative to what is emitted; may exceed 1 while light is being gathered
 * @param elements leaves of the mesh
 * @param error    relative error that was found when it was looked for last, see {@link Certificate#expected}; NaN
 *                 before
 * @param gathers  whether some of them are new and still gather what was shot before: the rest is as if they were not
 */
public record Progress(int shots, int rounds, double unsent, int elements, double error, boolean gathers) {

    /** Only numbers leave the solver. */
    public Progress {
        NoNumberException.unlessNumbers("unsent flux", unsent);
    }

    /** Before the error was looked for. */
    public Progress(int shots, int rounds, double unsent, int elements, boolean gathers) {
        this(shots, rounds, unsent, elements, Double.NaN, gathers);
    }
}
