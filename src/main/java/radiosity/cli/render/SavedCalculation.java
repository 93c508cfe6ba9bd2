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
 * A calculation that a scene file keeps, to go on from ({@code -tf}).
 *
 * @param file     as the user names it
 * @param shots    done so far
 * @param settings with which it was made; to go on needs the same
 */
public record SavedCalculation(Path file, int shots, RadiositySettings settings) {

    /** What is left of an accuracy after it was a tolerance. */
    private static final MathContext DIGITS = new MathContext(9);

    public static SavedCalculation read(Path file) throws IOException {
        return find(file).orElseThrow(() -> new SceneFormatException(file.toString(), "", "a calculation to go on from",
                "none"));
    }

    /** The calculation of a scene file; nothing where it keeps none. */
    public static Optional<SavedCalculation> find(Path file) throws IOException {
        try (SceneFile saved = SceneFile.open(file)) {
            Map<String, Object> extras = saved.extras();
            return extras.get("settings") instanceof Map<?, ?> settings && saved.hasState()
                    ? Optional.of(new SavedCalculation(file, (int) number(file, extras, "shots"),
                            settings(file, settings))) : Optional.empty();
        }
    }

    /** Reads what {@link radiosity.solver.ProgressiveRadiosity#resume} takes; it is large, and not kept here. */
    public SavedState state() throws IOException {
        try (SceneFile saved = SceneFile.open(file)) {
            return saved.state();
        }
    }

    /** What {@link #read} finds again in a scene file. */
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

    /** Those of the ray caster in files of before there were others. */
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

    /** Fails unless the user counts from the number that the file was saved with. */
    public void checkShots(int expected) {
        if (expected != shots) {
            throw Failure.commandLine("-tf", "expected " + shots + ", with which " + file + " was saved, got "
                    + expected);
        }
    }

    /** Fails where an option asks for something else than the file was made with. */
    public void checkSettings(RadiositySettings asked) {
        checkSetting("-pa", settings.patchArea(), asked.patchArea());
        checkSetting("-nr", settings.rays(), asked.rays());
        checkSetting("-mt", settings.meshing(), asked.meshing());
        checkSetting("--accuracy", perCent(settings), perCent(asked));
        checkSetting("--layers", settings.layers(), asked.layers());
        checkSetting("--form-factors", settings.factors(), asked.factors());
        checkSetting("--schedule", settings.schedule(), asked.schedule());
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

    /** As a user types it. */
    private static String typed(Object value) {
        return value.equals(Double.POSITIVE_INFINITY) || value.equals(0.0) || value.equals(0) ? "none"
                : value.toString().toLowerCase(Locale.ROOT);
    }
}
