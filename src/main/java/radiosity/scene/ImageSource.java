package radiosity.scene;

import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * Where the content of an image is: in a file of its own, or inside of another file.
 *
 * @param name    path of the image's file; for an image inside of another file, a name for messages
 * @param content bytes of an image inside of another file, not to be modified; empty for an image in a file of its own
 */
public record ImageSource(String name, Optional<ByteBuffer> content) {

    /** Of the name alone, as there may be many megabytes of content. */
    @Override
    public int hashCode() {
        return name.hashCode();
    }

    /** The image in the file with this path. */
    public static ImageSource file(String path) {
        return new ImageSource(path, Optional.empty());
    }
}
