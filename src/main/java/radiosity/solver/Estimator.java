package radiosity.solver;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import radiosity.certificate.Marked;
import radiosity.solution.Certificate;

/** Estimates the error of the present solution. */
interface Estimator {

    /** What an estimate finds: the error, and the elements that are to be divided. */
    record Estimate(Certificate certificate, Marked marked) { }

    /**
     * @param meshError error that interpolation on one element may add to the error of the whole solution, above 0
     * @param goOn      called now and then during the estimate, by the calling thread only
     * @return empty where there is no light
     * @throws CancellationException where {@code goOn} returns false
     */
    Optional<Estimate> estimate(double meshError, BooleanSupplier goOn) throws IOException;
}
