package radiosity.edit;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.solution.SavedState;

/**
 * What a scene file was made from, to be edited.
 *
 * @param model       that was read
 * @param reading     how
 * @param scene       what was read
 * @param file        the scene file
 * @param light       state of its solution
 * @param settings    with which it was made
 * @param kept        the same as the scene file has it
 * @param commandLine that made it
 */
public record EditSource(Path model, ReadOptions reading, Scene scene, Path file, SavedState light,
                         RadiositySettings settings, Map<?, ?> kept, List<String> commandLine) {

    public EditSource {
        commandLine = List.copyOf(commandLine);
    }
}
