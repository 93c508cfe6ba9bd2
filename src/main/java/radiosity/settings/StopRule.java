package radiosity.settings;

/**
 * When to stop: whichever comes first. In any case where what is unshot is only {@linkplain #ROUNDING rounding}.
 *
 * @param shots  number of shots after which to stop, at least 0 ({@code -it}); {@link Integer#MAX_VALUE} for no limit
 * @param unsent when at most this part of the emitted flux is unshot, in [0, 1] ({@code -se})
 */
public record StopRule(int shots, double unsent) {

    /** What is left unshot by default: far below what meshing and sampling leave. */
    public static final double DEFAULT_UNSENT = 1e-3;

    /**
     * What arithmetic leaves unshot for ever, relative to the flux that was shot or emitted, whichever is more: unshot
     * radiosity is the difference of what was gathered and what was shot.
     */
    public static final double ROUNDING = 1e-12;

    public StopRule {
        if (shots < 0 || !(unsent >= 0 && unsent <= 1)) {
            throw new IllegalArgumentException("stop rule: expected shots of at least 0 and a part in [0, 1], got "
                    + shots + " and " + unsent);
        }
    }
}
