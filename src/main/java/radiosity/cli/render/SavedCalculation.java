package radiosity.cli.render;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import radiosity.cli.options.CalculationOptions;
import radiosity.cli.options.Failure;
import radiosity.output.gltf.SceneFile;
import radiosity.scene.SceneFormatException;
import radiosity.settings.Accuracy;
import radiosity.settings.FormFactors;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.solution.SavedState;

/**
 * A calculation stored in a scene file, from which a later one can go on ({@code -tf}).
 *
 * @param file     path of the scene file as the user gave it
 * @param shots    number of shots done
 * @param settings of the calculation; only a calculation with the same settings can go on from it
 */
public record SavedCalculation(Path file, int shots, RadiositySettings settings) {

    /** Significant digits that an accuracy keeps when it is converted to a tolerance and back. */
    private static final MathContext DIGITS = new MathContext(9);

    /** @throws SceneFormatException where the scene file keeps no calculation */
    public static SavedCalculation read(Path file) throws IOException {
        return find(file).orElseThrow(() -> new SceneFormatException(file.toString(), "", "a calculation to go on from",
                "none"));
    }

    /** The calculation of a scene file; empty where the file keeps none. */
    public static Optional<SavedCalculation> find(Path file) throws IOException {
        try (SceneFile saved = SceneFile.open(file)) {
            Map<String, Object> extras = saved.extras();
            return extras.get("settings") instanceof Map<?, ?> settings && saved.hasState()
                    ? Optional.of(new SavedCalculation(file, (int) number(file, extras, "shots"),
                            settings(file, settings))) : Optional.empty();
        }
    }

    /** Reads the state, which is large, from the file for {@link radiosity.solver.ProgressiveRadiosity#resume}. */
    public SavedState state() throws IOException {
        try (SceneFile saved = SceneFile.open(file)) {
            return saved.state();
        }
    }

    /** The settings as a scene file stores them and {@link #read} reads them. */
    static Map<String, Object> asJson(RadiositySettings settings) {
        Map<String, Object> json = new TreeMap<>();
        json.put("patchArea", settings.patchArea());
        json.put("rays", settings.rays());
        if (Double.isFinite(settings.meshing())) {
            json.put("meshing", settings.meshing());
        }
        json.put("tolerance", settings.tolerance());
        json.put("meshError", settings.meshError());
        json.put("layers", settings.layers());
        json.put("formFactors", settings.factors().name().toLowerCase(Locale.ROOT));
        json.put("schedule", settings.schedule().name().toLowerCase(Locale.ROOT));
        return json;
    }

    private static RadiositySettings settings(Path file, Map<?, ?> json) throws SceneFormatException {
        Schedule schedule = new CalculationOptions.ScheduleParser().parse(String.valueOf(json.get("schedule")));
        if (schedule == null) {
            throw wrong(file, "a schedule", json.get("schedule"));
        }
        return new RadiositySettings(number(file, json, "patchArea"), (int) number(file, json, "rays"),
                json.containsKey("meshing") ? number(file, json, "meshing") : Double.POSITIVE_INFINITY, schedule,
                number(file, json, "tolerance"), number(file, json, "meshError"),
                        Boolean.TRUE.equals(json.get("layers")),
                formFactors(file, json));
    }

    /** Kind of form factors; scene files of earlier versions, which had only the ray caster, do not name it. */
    private static FormFactors formFactors(Path file, Map<?, ?> json) throws SceneFormatException {
        Object name = json.get("formFactors");
        FormFactors factors = name == null ? FormFactors.RAYCAST
                : new CalculationOptions.FormFactorsParser().parse(String.valueOf(name));
        if (factors == null) {
            throw wrong(file, "form factors", name);
        }
        return factors;
    }

    private static double number(Path file, Map<?, ?> json, String name) throws SceneFormatException {
        if (json.get(name) instanceof Number number) {
            return number.doubleValue();
        }
        throw wrong(file, "a number as " + name, json.get(name));
    }

    private static SceneFormatException wrong(Path file, String expected, Object got) {
        return new SceneFormatException(file.toString(), "extras.radiosity.settings", expected, String.valueOf(got));
    }

    /** Fails unless the number of shots given with {@code -tf} is the number of shots in the file. */
    public void checkShots(int expected) {
        if (expected != shots) {
            throw Failure.commandLine("-tf", "expected " + shots + ", with which " + file + " was saved, got "
                    + expected);
        }
    }

    /**
     * The settings with which this calculation goes on: its own accuracy first, where a smaller error is asked for.
     * Fails where another option differs.
     */
    public RadiositySettings goingOn(RadiositySettings asked) {
        RadiositySettings next = settings.isCoarserThan(Accuracy.of(asked.tolerance())) ? asked.asAccurateAs(settings)
                : asked;
        checkSetting("-pa", settings.patchArea(), next.patchArea());
        checkSetting("-nr", settings.rays(), next.rays());
        checkSetting("-mt", settings.meshing(), next.meshing());
        checkSetting("--accuracy", perCent(settings), perCent(next));
        checkSetting("--layers", settings.layers(), next.layers());
        checkSetting("--form-factors", settings.factors(), next.factors());
        checkSetting("--schedule", settings.schedule(), next.schedule());
        return next;
    }

    private void checkSetting(String option, Object saved, Object asked) {
        if (!saved.equals(asked)) {
            throw Failure.commandLine(option, "expected " + typed(saved) + ", with which " + file + " was made, got "
                    + typed(asked));
        }
    }

    private static String perCent(RadiositySettings of) {
        return new BigDecimal(100 * Accuracy.of(of.tolerance())).round(DIGITS).stripTrailingZeros().toPlainString()
                + "%";
    }

    /** A value as the user types it in an option; "none" for 0 and infinity. */
    private static String typed(Object value) {
        return value.equals(Double.POSITIVE_INFINITY) || value.equals(0.0) || value.equals(0) ? "none"
                : value.toString().toLowerCase(Locale.ROOT);
    }
}
