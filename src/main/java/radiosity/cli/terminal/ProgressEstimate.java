package radiosity.cli.terminal;

import radiosity.solution.Progress;

/** Estimates how much of a render is done. */
public interface ProgressEstimate {

    /** Part of the render that is done, in [0, 1]. */
    double done(Progress now);

    /** Time until the render ends, s; 0: not known. */
    double left(Progress now);

    /** Relative error at which the render ends; NaN where it ends by another criterion. */
    double asked();

    /** Text to print before the progress; empty: none. */
    String label();
}
