package radiosity.testkit;

/** The sets of points that {@code truth/score.py} reports, in its words. */
public enum PointSet {
    /** On surfaces that do not emit: the headline. */
    REFLECTORS,
    /** In a penumbra, or near another surface; not weighted. */
    NEAR,
    /** In the room without direct light. */
    DARK,
    /** All that stand for an area. */
    ALL;

    private static final int NEARNESS = 1 | 2;
    private static final int EMITTER = 4;
    private static final int DARKNESS = 8;

    /**
     * @param weight area for which a point stands, m²; 0 for an extra point
     * @param tag    bits as {@code truth/README.md} has them
     * @return the weight in this set; negative where the point is not in it
     */
    double weight(double weight, int tag) {
        boolean reflects = (tag & EMITTER) == 0;
        return switch (this) {
            case REFLECTORS -> reflects && weight > 0 ? weight : -1;
            case NEAR -> reflects && (tag & NEARNESS) != 0 ? 1 : -1;
            case DARK -> reflects && weight > 0 && (tag & DARKNESS) != 0 ? weight : -1;
            case ALL -> weight > 0 ? weight : -1;
        };
    }
}
