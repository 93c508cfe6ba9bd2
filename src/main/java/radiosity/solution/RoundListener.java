package radiosity.solution;

import java.io.IOException;

/** Is called after every step of a round, and several times a second during other work; may stop the calculation. */
@FunctionalInterface
public interface RoundListener {

    /**
     * @param progress state of the calculation
     * @return whether to go on
     */
    boolean afterRound(Progress progress);

    /**
     * Is called after each estimate of the error, before mesh or rays are refined: the solution is the one that was
     * estimated.
     *
     * @param progress state of the calculation
     * @return whether to go on; where not, the result is that of a {@code StopRule} with as many estimates
     * @throws IOException where the solution cannot be asked for or kept
     */
    default boolean afterEstimate(Progress progress) throws IOException {
        return true;
    }
}
