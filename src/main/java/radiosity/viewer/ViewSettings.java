package radiosity.viewer;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import radiosity.edit.EditSource;
import radiosity.output.image.ToneMapping;

/**
 * How a window begins.
 *
 * @param title       of the window
 * @param wireframe   whether to show the elements' edges only ({@code -wf})
 * @param textures    whether to show the light of the textures ({@code -ut})
 * @param toneMapping how radiosity becomes brightness; empty: automatic exposure
 * @param curve       of the automatic choice
 * @param stops       how much brighter than the automatic choice, EV
 * @param width       pixels
 * @param height      pixels, or 0 to follow the camera's aspect
 * @param followed    the scene file, to be shown again when it is replaced
 * @param editing     reads what the scene file was made from, where it can be edited
 * @param screenshot  a picture to write of the first complete view, whereupon the window closes
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
