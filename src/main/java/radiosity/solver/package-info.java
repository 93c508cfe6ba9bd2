/**
 * Figure 7 of the paper: the loop of rounds, the schedules that choose shots, and the world whose elements are in this
 * process.
 *
 * <p>Rounds, stop rule and the choice of shooters belong to {@link radiosity.solver.ProgressiveRadiosity}. A listener
 * reads; it never advances the calculation.
 */
package radiosity.solver;
