package radiosity.cli;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import radiosity.world.Certificate;
import radiosity.world.EnergyLedger;
import radiosity.world.Progress;

/** What a render came to: for the user in lines, for programs as JSON. */
final class Summary {

    /** From here on the estimates of errors are mostly about what is unsent. */
    private static final double MUCH_UNSENT = 0.01;

    private final Progress progress;
    private final EnergyLedger ledger;
    private final Optional<Certificate> certificate;
    private final double patchArea;
    private final double seconds;

    /**
     * @param patchArea square scene units
     * @param seconds   of wall time, of the whole program so far
     */
    Summary(Progress progress, EnergyLedger ledger, Optional<Certificate> certificate, double patchArea,
            double seconds) {
        this.progress = progress;
        this.ledger = ledger;
        this.certificate = certificate;
        this.patchArea = patchArea;
        this.seconds = seconds;
    }

    void print(PrintStream out) {
        out.printf(Locale.ROOT, "%,d elements of patches up to %.4g, %s in %s, %s unsent, %s%n",
                progress.elements(), patchArea, ProgressText.count(progress.shots(), "shot"),
                ProgressText.count(progress.rounds(), "round"),
                ProgressText.perCent(progress.unsent()), ProgressText.time(seconds));
        out.printf(Locale.ROOT, "emitted %.6g W = absorbed %.6g + unshot %.6g + not received %.6g%n",
                sum(ledger.emitted()), sum(ledger.absorbed()), sum(ledger.unshot()), deficit());
        certificate.ifPresent(c -> print(c, out));
    }

    private void print(Certificate c, PrintStream out) {
        String missing = c.missingFlux() == null ? "without a bound on what is still missing"
                : String.format(Locale.ROOT, "about %.4g W at most still missing", c.missingFlux());
        String parts = progress.unsent() > MUCH_UNSENT ? "what is still unsent among it" : String.format(Locale.ROOT,
                "rays %s, mesh %s", ProgressText.perCent(c.sampling()), ProgressText.perCent(c.meshing()));
        out.printf(Locale.ROOT, "radiosity +- %s (%s), estimated at %d points; %s%n",
                ProgressText.perCent(c.expected()), parts, c.points(), missing);
        out.printf(Locale.ROOT, "form factors add up to %.4f on average, %.4f at most; two ways they differ by %s%n",
                c.factors(), c.mostFactors(), ProgressText.perCent(c.reciprocity()));
    }

    /** Of JSON's types. */
    Map<String, Object> asJson() {
        Map<String, Object> json = new TreeMap<>();
        json.put("elements", progress.elements());
        json.put("shots", progress.shots());
        json.put("rounds", progress.rounds());
        json.put("unsent", progress.unsent());
        json.put("patchArea", patchArea);
        json.put("seconds", seconds);
        json.put("ledger", ledger);
        certificate.ifPresent(c -> json.put("certificate", c));
        return json;
    }

    private double deficit() {
        return sum(ledger.shot()) - sum(ledger.received());
    }

    private static double sum(double[] channels) {
        return Arrays.stream(channels).sum();
    }
}
