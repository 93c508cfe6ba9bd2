package radiosity.solver;

import java.io.IOException;
import java.util.Optional;
import radiosity.certificate.Marked;
import radiosity.solution.Certificate;

/** Estimates the error of the present solution. */
interface Estimator {

    /** What an estimate finds: the error, and the elements that are to be divided. */
    record Estimate(Certificate certificate, Marked marked) { }

    /**
     * @param meshError error that interpolation on one element may add to the error of the whole solution, above 0
     * @return empty where there is no light
     */
    Optional<Estimate> estimate(double meshError) throws IOException;
}
