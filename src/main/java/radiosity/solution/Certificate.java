package radiosity.solution;

import java.util.List;
import radiosity.util.NoNumberException;

/**
 * An estimate of a solution's error.
 *
 * <p>{@code missingFlux} is an upper bound, for the discrete system. The errors are estimates: at some points of every
 * surface the irradiance from the solution's radiosity is computed anew, twice, with rays of its own, and compared with
 * the solution's irradiance; the product of the two differences is free of the noise of these rays. Light that is still
 * unshot counts as error, so it is most of the error early in a render.
 * {@code docs/CERTIFICATE.md} says how well the estimates predict the true error.
 *
 * @param points      number of points at which the irradiance was computed anew
 * @param missingFlux upper bound of the flux that can still arrive as unshot flux is shot, sum over all channels, W;
 *                    null where there is no bound
 * @param factors     mean over the points of the sum of form factors at a point; 1 in a closed scene
 * @param mostFactors largest sum of form factors at a point
 * @param reciprocity mean difference between A F of a pair of patches and A F the other way, relative to the mean A F
 * @param expected    expected error of radiosity: root mean square over all surfaces that reflect and do not emit,
 *                    relative to their mean radiosity or a third of a place's own radiosity, whichever is more; the
 *                    next four numbers are relative to the same radiosity
 * @param sampling    part of the error at a point that comes from rays
 * @param meshing     part of the error at a point that comes from interpolation
 * @param bias        mean error, which interreflection multiplies; signed
 * @param uncertainty part of the error that may be the estimate's own: standard error of the bias where interreflection
 *                    multiplies what the points tell of it
 * @param surfaces    errors of each surface
 */
public record Certificate(int points, Double missingFlux, double factors, double mostFactors, double reciprocity,
                          double expected, double sampling, double meshing, double bias,
                          double uncertainty, List<SurfaceError> surfaces) {

    /** @throws NoNumberException where a number is infinite or NaN */
    public Certificate {
        NoNumberException.unlessNumbers("certificate", missingFlux == null ? 0 : missingFlux, factors, mostFactors,
                reciprocity, expected, sampling, meshing, bias, uncertainty);
    }

    /**
     * Errors at a point of one surface, relative to its own mean radiosity, and its share of the whole error.
     *
     * @param surface   name of the surface
     * @param points    number of points on the surface
     * @param radiosity mean over these points and over the channels, W/m²
     * @param sampling  part of the error that comes from rays
     * @param meshing   part of the error that comes from interpolation
     * @param share     part of the mean square of {@link Certificate#expected} that is on the surface, in [0, 1]; bias
     *                  that all surfaces have in common is left out
     */
    public record SurfaceError(String surface, int points, double radiosity, double sampling, double meshing,
                               double share) {

        public SurfaceError {
            NoNumberException.unlessNumbers("certificate", radiosity, sampling, meshing, share);
        }
    }
}
