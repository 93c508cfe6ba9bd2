package radiosity.output;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import radiosity.scene.Srgb;

/** An image as its file has it, values from 0 to 1. */
final class ImageFile {

    /** A larger image is not read: a small crafted file may say that it is of any size. */
    private static final long MOST_PIXELS = 1L << 26;

    private final BufferedImage image;
    private final boolean grey;
    private final double most;

    private ImageFile(BufferedImage image) {
        this.image = image;
        // the colours that Java makes of grey are brighter than the file's values
        grey = image.getColorModel().getColorSpace().getType() == ColorSpace.TYPE_GRAY;
        most = (1L << image.getColorModel().getComponentSize(0)) - 1;
    }

    /** @throws IOException with a reason for the user if it cannot be read */
    static ImageFile read(Path path) throws IOException {
        try (ImageInputStream in = ImageIO.createImageInputStream(path.toFile())) {
            Iterator<ImageReader> readers = in == null ? null : ImageIO.getImageReaders(in);
            if (readers == null || !readers.hasNext()) {
                throw new IOException(in == null ? "a file that cannot be read" : "a format that is not known");
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(in);
                long pixels = (long) reader.getWidth(0) * reader.getHeight(0);
                if (pixels > MOST_PIXELS) {
                    throw new IOException("one of " + pixels + " pixels, more than " + MOST_PIXELS);
                }
                return new ImageFile(reader.read(0));
            } catch (RuntimeException e) {
                throw new IOException("a broken one (" + e.getMessage() + ")", e);
            } finally {
                reader.dispose();
            }
        }
    }

    int width() {
        return image.getWidth();
    }

    int height() {
        return image.getHeight();
    }

    /** @param mean of the three channels instead of one */
    double value(int x, int y, int channel, boolean mean, boolean srgb) {
        return mean ? (value(x, y, 0, srgb) + value(x, y, 1, srgb) + value(x, y, 2, srgb)) / 3 : value(x, y, channel, srgb);
    }

    private double value(int x, int y, int channel, boolean srgb) {
        double code = grey ? image.getRaster().getSample(x, y, 0) / most
                : (image.getRGB(x, y) >> 16 - 8 * channel & 0xFF) / 255.0;
        return srgb ? Srgb.linear(code) : code;
    }
}
