package radiosity.cli.terminal;

import radiosity.solution.Progress;

/** How far a render is on its way. */
public interface ProgressEstimate {

    /** Part of the way, in [0, 1]. */
    double done(Progress now);

    /** Seconds that it still takes; 0: not known. */
    double left(Progress now);

    /** Relative error at which the way ends; NaN where it ends by something else. */
    double asked();

    /** Words before the progress; empty: none. */
    String label();
}
