package radiosity.formfactor;

import radiosity.visibility.RadiosityBounds;

/** The ways to find form factors (section 2.3 of the paper). */
public enum FormFactors {
    /** Exact where nothing is in between, and rays for what is visible: {@link RayCaster}. */
    RAYCAST {
        @Override
        public FormFactorCalculator calculator(RadiosityBounds bounds, int rays, double tolerance) {
            return new RayCaster(bounds, rays, tolerance);
        }
    },
    /** The paper's rays: {@link PlainRays}. */
    PLAIN {
        @Override
        public FormFactorCalculator calculator(RadiosityBounds bounds, int rays, double tolerance) {
            return new PlainRays(bounds, rays);
        }
    },
    /** {@link Hemicube}. */
    HEMICUBE {
        @Override
        public FormFactorCalculator calculator(RadiosityBounds bounds, int rays, double tolerance) {
            return new Hemicube(bounds, rays);
        }
    },
    /** {@link Nusselt}. */
    NUSSELT {
        @Override
        public FormFactorCalculator calculator(RadiosityBounds bounds, int rays, double tolerance) {
            return new Nusselt(bounds, rays);
        }
    };

    /**
     * One of them at work.
     *
     * @param rays      sample points per shooter, or cells along an edge
     * @param tolerance how much one ray may carry, see {@link RayCaster}; the others know no such thing
     */
    public abstract FormFactorCalculator calculator(RadiosityBounds bounds, int rays, double tolerance);

    /** Rays where no number is given: as many cells along an edge as cost about as much as the ray caster. */
    public int rays(int forRays) {
        return switch (this) {
            case RAYCAST, PLAIN -> forRays;
            case HEMICUBE -> Hemicube.DEFAULT_CELLS;
            case NUSSELT -> Nusselt.DEFAULT_CELLS;
        };
    }
}
