package radiosity.cli;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import radiosity.world.EnergyLedger;
import radiosity.world.Progress;

/** What a render came to: for the user in lines, for programs as JSON. */
final class Summary {

    private final Progress progress;
    private final EnergyLedger ledger;
    private final double patchArea;
    private final double seconds;

    /**
     * @param patchArea square scene units
     * @param seconds   of wall time, of the whole program so far
     */
    Summary(Progress progress, EnergyLedger ledger, double patchArea, double seconds) {
        this.progress = progress;
        this.ledger = ledger;
        this.patchArea = patchArea;
        this.seconds = seconds;
    }

    void print(PrintStream out) {
        out.printf(Locale.ROOT, "%,d elements of patches up to %.4g, %,d shots in %,d rounds, %s unsent, %s%n",
                progress.elements(), patchArea, progress.shots(), progress.rounds(),
                ProgressText.perCent(progress.unsent()), ProgressText.time(seconds));
        out.printf(Locale.ROOT, "emitted %.6g W = absorbed %.6g + unshot %.6g + not received %.6g%n",
                sum(ledger.emitted()), sum(ledger.absorbed()), sum(ledger.unshot()), deficit());
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
        return json;
    }

    private double deficit() {
        return sum(ledger.shot()) - sum(ledger.received());
    }

    private static double sum(double[] channels) {
        return Arrays.stream(channels).sum();
    }
}
