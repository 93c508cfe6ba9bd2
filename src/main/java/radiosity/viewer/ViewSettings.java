package radiosity.viewer;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import radiosity.edit.EditSource;
import radiosity.output.image.ToneMapping;

/**
 * Settings with which a window opens.
 *
 * @param title       title of the window
 * @param wireframe   whether to show only the edges of elements ({@code -wf})
 * @param textures    whether to show the light of the textures ({@code -ut})
 * @param toneMapping mapping of radiosity to colours; empty: automatic exposure
 * @param curve       curve of the automatic exposure
 * @param stops       brightness relative to the automatic exposure, EV
 * @param width       pixels
 * @param height      pixels; 0 to follow the camera's aspect
 * @param followed    the scene file, which is shown again when it is replaced
 * @param editing     reads the source of the scene file, where the scene can be edited
 * @param screenshot  file for a picture of the first complete view, after which the window closes
 */
public record ViewSettings(String title, boolean wireframe, boolean textures,
                           Optional<ToneMapping> toneMapping, ToneMapping.Operator curve, double stops, int width,
                           int height, Optional<Path> followed, Optional<Callable<EditSource>> editing,
                           Optional<Path> screenshot) {

    public ViewSettings {
        if (width < 1 || height < 0) {
            throw new IllegalArgumentException("window: expected a size of at least 1x1, got " + width + "x" + height);
        }
    }
}
