package radiosity.solution;

import java.util.List;
import radiosity.util.NoNumberException;

/**
 * How far a solution can be trusted.
 *
 * <p>The bound is one, on what the discrete system still lacks. The errors are estimates: at some points of every
 * surface the light that arrives from the solution is found anew with many more rays, and compared with what the
 * solution has there. Light that is still unshot is found, too, so early in a render it is most of them. {@code
 * docs/CERTIFICATE.md} says how well they foresee the true error.
 *
 * @param points      at how many points it was looked
 * @param missingFlux most flux that could still arrive as unshot flux is shot, all channels, W; null: without a bound
 * @param factors     mean sum of the form factors at a point; 1 where all is closed
 * @param mostFactors the largest
 * @param reciprocity mean difference between A F of pairs of patches and A F the other way, relative to its mean
 * @param expected    expected error of radiosity: root of the mean square over all that reflects and does not emit,
 *                    relative to the mean radiosity there, or to a third of what is there where that is more; the
 *                    same for the next three
 * @param sampling    the part that rays leave at a point
 * @param meshing     the part that interpolation leaves at a point
 * @param bias        mean error, as it builds up by interreflection; signed
 * @param surfaces    one by one
 */
public record Certificate(int points, Double missingFlux, double factors, double mostFactors, double reciprocity,
                          double expected, double sampling, double meshing, double bias,
                          List<SurfaceError> surfaces) {

    /** Only numbers leave the solver. */
    public Certificate {
        NoNumberException.unlessNumbers("certificate", missingFlux == null ? 0 : missingFlux, factors, mostFactors,
                reciprocity, expected, sampling, meshing, bias);
    }

    /**
     * Errors at a point of one surface, relative to its own mean radiosity.
     *
     * @param surface   its name
     * @param points    at how many points it was looked
     * @param radiosity mean over them and over the channels, W/m²
     * @param sampling  what rays leave
     * @param meshing   what interpolation leaves
     */
    public record SurfaceError(String surface, int points, double radiosity, double sampling, double meshing) {

        public SurfaceError {
            NoNumberException.unlessNumbers("certificate", radiosity, sampling, meshing);
        }
    }
}
