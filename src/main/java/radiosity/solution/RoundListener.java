package radiosity.solution;

/** Called after every round; may ask to stop. */
@FunctionalInterface
public interface RoundListener {

    /**
     * @param progress where the calculation stands
     * @return whether to go on
     */
    boolean afterRound(Progress progress);
}
