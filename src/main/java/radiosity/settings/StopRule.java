package radiosity.settings;

/**
 * Conditions under which a calculation stops: the number of shots is reached, or little is unshot, whichever comes
 * first. It always stops where the unshot flux is only {@linkplain #ROUNDING rounding}.
 *
 * @param shots  number of shots after which to stop, at least 0 ({@code -it}); {@link Integer#MAX_VALUE} for no limit
 * @param unsent unshot part of the emitted flux at or below which to stop, in [0, 1] ({@code -se})
 */
public record StopRule(int shots, double unsent) {

    /** Default of the unshot part: far below the errors that meshing and sampling leave. */
    public static final double DEFAULT_UNSENT = 1e-3;

    /**
     * Unshot flux that is only rounding, relative to the flux shot or emitted, whichever is more: unshot radiosity is
     * the difference of two nearly equal radiosities, of reflected and of shot light.
     */
    public static final double ROUNDING = 1e-12;

    /** @throws IllegalArgumentException where the shots are negative or the part is not in [0, 1] */
    public StopRule {
        if (shots < 0 || !(unsent >= 0 && unsent <= 1)) {
            throw new IllegalArgumentException("stop rule: expected shots of at least 0 and a part in [0, 1], got "
                    + shots + " and " + unsent);
        }
    }
}
