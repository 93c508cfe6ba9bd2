package radiosity.cli.render;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import radiosity.cli.terminal.ProgressText;
import radiosity.scene.Units;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;
import radiosity.solution.Progress;

/** Summary of a render: for the user as lines, for programs as JSON. */
public final class Summary {

    /** Part of the emitted flux above which estimates of errors are mostly about flux that is still unshot. */
    private static final double MUCH_UNSENT = 0.05;
    /** Number of surfaces that are named where the error is larger than was asked for. */
    private static final int WORST = 3;

    private final RenderResult result;
    private final Progress progress;
    private final EnergyLedger ledger;
    private final Units units;
    private final Optional<String> inTime;
    private final double seconds;

    /**
     * @param inTime  line about the time limit, where there was a time limit
     * @param seconds wall time of the process so far
     */
    public Summary(RenderResult result, Optional<String> inTime, double seconds) {
        this.result = result;
        this.inTime = inTime;
        this.seconds = seconds;
        progress = result.progress();
        ledger = result.solution().ledger();
        units = result.solution().scene().units();
    }

    public void print(PrintStream out) {
        out.printf(Locale.ROOT, "%s, initial patches <= %.4g units\u00b2, %s in %s, %s of the"
                + " light not yet distributed or shot too much, %s%n",
                ProgressText.count(progress.elements(), "mesh element"), result.patchArea(),
                ProgressText.count(progress.shots(), "shot"),
                ProgressText.count(progress.rounds(), "round"),
                ProgressText.perCent(progress.unsent()), ProgressText.time(seconds));
        out.printf(Locale.ROOT, "emitted %.6g %s = absorbed %.6g + not yet distributed %.6g + %s%n",
                units.flux(ledger.emitted()), units.flux(), units.flux(ledger.absorbed()),
                units.flux(ledger.unshot()), notReceived());
        if (progress.gathers()) {
            out.println("stopped while the mesh was being refined: new elements show, and these figures count, the"
                    + " light of before they were made");
        }
        if (result.isRounding()) {
            out.println("-se: what is not yet distributed is only rounding; no calculation leaves less");
        }
        result.certificate().ifPresent(c -> print(c, out));
        inTime.ifPresent(out::println);
    }

    private void print(Certificate c, PrintStream out) {
        String parts = progress.unsent() > MUCH_UNSENT ? "with what is not yet distributed" : String.format(Locale.ROOT,
                "rays %s, mesh %s", ProgressText.perCent(c.sampling()), ProgressText.perCent(c.meshing()));
        out.printf(Locale.ROOT, "radiosity +- %s (%s), estimated at %d points; %s%n",
                ProgressText.perCent(c.expected()), parts, c.points(), missing(c));
        out.printf(Locale.ROOT, "mean form-factor sum %.4f, largest %.4f, reciprocity error %s%n",
                c.factors(), c.mostFactors(), ProgressText.perCent(c.reciprocity()));
    }

    /** The upper bound on missing flux; near a reflectance of 1 it may be large without meaning anything. */
    private String missing(Certificate c) {
        if (c.missingFlux() == null) {
            return "no upper bound on missing flux";
        }
        return "upper bound on missing flux: " + (c.missingFlux() > Arrays.stream(ledger.emitted()).sum()
                ? "more than is emitted"
                : String.format(Locale.ROOT, "%.4g %s", units.fluxLike(c.missingFlux(), ledger.emitted()),
                        units.flux()));
    }

    /**
     * The line for a radiosity that is less exact than was asked for, with the surfaces that have most of the error;
     * empty where the radiosity is exact enough or its error is not known.
     */
    public Optional<String> shortfall() {
        double asked = result.asked().orElse(Double.POSITIVE_INFINITY);
        return result.certificate().filter(c -> c.expected() > asked).map(c -> String.format(Locale.ROOT,
                "accuracy not reached: expected an error of %s, got %s%s", ProgressText.perCent(asked),
                ProgressText.perCent(c.expected(), 3), worst(c)));
    }

    /** The surfaces that have most of the error, for the end of a line; empty where none has any. */
    public static String worst(Certificate certificate) {
        String most = certificate.surfaces().stream().filter(s -> s.share() > 0)
                .sorted(Comparator.comparingDouble(Certificate.SurfaceError::share).reversed()).limit(WORST)
                .map(s -> String.format(Locale.ROOT, "%.0f %% of it is on %s", 100 * s.share(), s.surface()))
                .collect(Collectors.joining(", "));
        return most.isEmpty() ? "" : "; " + most;
    }

    /** The summary by names, for Jackson to write as JSON. */
    Map<String, Object> asJson() {
        Map<String, Object> json = new TreeMap<>();
        json.put("elements", progress.elements());
        json.put("shots", progress.shots());
        json.put("rounds", progress.rounds());
        json.put("unsent", progress.unsent());
        json.put("patchArea", result.patchArea());
        json.put("settings", SavedCalculation.asJson(result.settings()));
        json.put("seconds", seconds);
        json.put("ledger", ledger);
        json.put("flux", Map.of("unit", units.flux(), "emitted", units.flux(ledger.emitted()),
                "absorbed", units.flux(ledger.absorbed()), "unshot", units.flux(ledger.unshot()),
                "notReceived", deficit()));
        json.put("photometric", units.isPhotometric());
        if (units.isLengthKnown()) {
            json.put("metresPerUnit", units.metres());
        }
        if (units.isPhotometric()) {
            json.put("luminanceWeights", List.of(Units.WEIGHTS.r(), Units.WEIGHTS.g(), Units.WEIGHTS.b()));
        }
        result.certificate().ifPresent(c -> json.put("certificate", c));
        result.certificate().filter(c -> c.missingFlux() != null).ifPresent(c -> json.put("missingFluxBound",
                units.fluxLike(c.missingFlux(), ledger.emitted())));
        inTime.ifPresent(line -> json.put("inTime", line));
        return json;
    }

    /** What was shot and not received: where rays have found what of it escaped, that and the rest. */
    private String notReceived() {
        if (!ledger.knowsEscaped()) {
            return String.format(Locale.ROOT, "escaped or lost %.6g", deficit());
        }
        double escaped = units.flux(ledger.escaped());
        return String.format(Locale.ROOT, "escaped %.6g + lost %.6g", escaped, deficit() - escaped);
    }

    private double deficit() {
        return units.flux(ledger.shot()) - units.flux(ledger.received());
    }
}
