package radiosity.solution;

/** Is called after every step of a round, and several times a second during other work; may stop the calculation. */
@FunctionalInterface
public interface RoundListener {

    /**
     * @param progress state of the calculation
     * @return whether to go on
     */
    boolean afterRound(Progress progress);
}
