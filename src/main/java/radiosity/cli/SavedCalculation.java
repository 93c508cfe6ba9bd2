package radiosity.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import radiosity.output.SceneFile;
import radiosity.scene.SceneFormatException;
import radiosity.world.RadiositySettings;
import radiosity.world.Schedule;

/**
 * A calculation that a scene file keeps, to go on from ({@code -tf}).
 *
 * @param file     as the user names it
 * @param shots    done so far
 * @param settings with which it was made; to go on needs the same
 * @param state    for {@link radiosity.world.ProgressiveRadiosity#resume}
 */
record SavedCalculation(Path file, int shots, RadiositySettings settings, byte[] state) {

    static SavedCalculation read(Path file) throws IOException {
        try (SceneFile saved = SceneFile.open(file)) {
            Map<String, Object> extras = saved.extras();
            if (!(extras.get("settings") instanceof Map<?, ?> settings) || saved.state().length == 0) {
                throw new SceneFormatException(file.toString(), "", "a calculation to go on from", "none");
            }
            return new SavedCalculation(file, ((Number) extras.get("shots")).intValue(), settings(settings),
                    saved.state());
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
        json.put("schedule", settings.schedule().name().toLowerCase(Locale.ROOT));
        return json;
    }

    private static RadiositySettings settings(Map<?, ?> json) {
        Object meshing = json.get("meshing");
        return new RadiositySettings(((Number) json.get("patchArea")).doubleValue(),
                ((Number) json.get("rays")).intValue(),
                meshing == null ? Double.POSITIVE_INFINITY : ((Number) meshing).doubleValue(),
                Schedule.valueOf(json.get("schedule").toString().toUpperCase(Locale.ROOT)));
    }

    /** Fails unless the user counts from the number that the file was saved with. */
    void checkShots(int expected) {
        if (expected != shots) {
            throw Failure.commandLine("-tf", "expected " + shots + ", with which " + file + " was saved, got "
                    + expected);
        }
    }

    /** Fails where an option asks for something else than the file was made with. */
    void checkSettings(RadiositySettings asked) {
        checkSetting("-pa", settings.patchArea(), asked.patchArea());
        checkSetting("-nr", settings.rays(), asked.rays());
        checkSetting("-mt", settings.meshing(), asked.meshing());
        checkSetting("--schedule", settings.schedule(), asked.schedule());
    }

    private void checkSetting(String option, Object saved, Object asked) {
        if (!saved.equals(asked)) {
            throw Failure.commandLine(option, "expected " + saved + ", with which " + file + " was made, got " + asked);
        }
    }
}
