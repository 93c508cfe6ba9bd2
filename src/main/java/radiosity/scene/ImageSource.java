package radiosity.scene;

import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * Where an image is.
 *
 * @param name    path of a file that the reader found; of an image inside of another file, what to call it
 * @param content the bytes of an image inside of another file, not to be modified
 */
public record ImageSource(String name, Optional<ByteBuffer> content) {

    /** An image in a file of its own. */
    public static ImageSource file(String path) {
        return new ImageSource(path, Optional.empty());
    }
}
