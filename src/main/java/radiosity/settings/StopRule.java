package radiosity.settings;

/**
 * Conditions under which a calculation stops: the number of shots or of estimates is reached, or little is unshot,
 * whichever comes first. It always stops where the unshot flux is only {@linkplain #ROUNDING rounding}.
 *
 * @param shots  number of shots after which to stop, at least 0 ({@code -it}); {@link Integer#MAX_VALUE} for no limit
 * @param unsent unshot part of the emitted flux at or below which to stop, in [0, 1] ({@code -se}), by the schedules of
 *               the paper; with prediction the calculation ends where its accuracy is reached
 * @param estimates number of estimates of the error after which to stop, at least 1 ({@code --estimates}), where the
 *                  schedule estimates the error; {@link Integer#MAX_VALUE} for no limit
 */
public record StopRule(int shots, double unsent, int estimates) {

    /** Default of the unshot part: far below the errors that meshing and sampling leave. */
    public static final double DEFAULT_UNSENT = 1e-3;

    /**
     * Unshot flux that is only rounding, relative to the flux shot or emitted, whichever is more: unshot radiosity is
     * the difference of two nearly equal radiosities, of reflected and of shot light.
     */
    public static final double ROUNDING = 1e-12;

    /** @throws IllegalArgumentException where a number is out of its range */
    public StopRule {
        if (shots < 0 || !(unsent >= 0 && unsent <= 1) || estimates < 1) {
            throw new IllegalArgumentException("stop rule: expected shots of at least 0, a part in [0, 1] and estimates"
                    + " of at least 1, got " + shots + ", " + unsent + " and " + estimates);
        }
    }

    /**
     * A rule without a limit on estimates.
     *
     * @throws IllegalArgumentException where a number is out of its range
     */
    public StopRule(int shots, double unsent) {
        this(shots, unsent, Integer.MAX_VALUE);
    }
}
