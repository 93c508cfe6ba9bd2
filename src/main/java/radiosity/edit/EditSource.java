package radiosity.edit;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.solution.SavedState;

/**
 * A scene file to be edited, with the model and the settings that it was made from.
 *
 * @param model       file of the model
 * @param reading     options with which the model is read
 * @param scene       scene read from the model
 * @param file        the scene file
 * @param light       state of the scene file's solution
 * @param settings    settings of that solution
 * @param kept        the same settings as JSON values of the scene file
 * @param commandLine command line that made the scene file
 */
public record EditSource(Path model, ReadOptions reading, Scene scene, Path file, SavedState light,
                         RadiositySettings settings, Map<?, ?> kept, List<String> commandLine) {

    public EditSource {
        commandLine = List.copyOf(commandLine);
    }
}
