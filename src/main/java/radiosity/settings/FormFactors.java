package radiosity.settings;

/** The ways to compute form factors (section 2.3 of the paper). */
public enum FormFactors {
    /** The exact factor to an unoccluded shooter times its visible share, which rays estimate (section 2.3.2). */
    RAYCAST,
    /** The paper's own rays to random points of the shooter (section 2.3.2). */
    PLAIN,
    /** Projection onto half a cube around the receiving point (section 2.3.1). */
    HEMICUBE,
    /** Nusselt's projection onto half a sphere, then onto a circle (section 2.3.3). */
    NUSSELT
}
