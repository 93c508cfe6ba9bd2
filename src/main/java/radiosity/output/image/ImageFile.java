package radiosity.output.image;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import radiosity.scene.ImageSource;
import radiosity.scene.Srgb;

/**
 * An image with the values that its file has, whatever their type: integers as fractions of the largest value of the
 * type, floats as they are. Alpha is ignored: a transparent pixel keeps its colour. Colour profiles are not applied;
 * only indexed colours and colour models other than grey and RGB (CIE Lab) are converted. CMYK becomes (1 - C)(1 - K),
 * (1 - M)(1 - K) and (1 - Y)(1 - K), as image programs have it without a profile; Java's conversion gives pale colours.
 */
final class ImageFile {

    /** Of images with more pixels only every second, third, ... pixel and row is read. */
    static final long MOST_PIXELS = 1L << 26;
    /** Images with more pixels are not read, because a small crafted file may claim any size. */
    private static final long MOST_IN_FILE = 1L << 30;

    private final BufferedImage image;
    private final int step;
    private final Raster samples;
    private final ColorModel model;
    /** Whether the samples are the values: not if they are indices of colours, or belong to another colour model. */
    private final boolean direct;
    private final boolean grey;
    private final boolean inks;

    /** @throws IOException if a value of the image is NaN or infinite */
    ImageFile(BufferedImage image) throws IOException {
        this(image, 1);
    }

    private ImageFile(BufferedImage image, int step) throws IOException {
        this.image = image;
        this.step = step;
        samples = image.getRaster();
        model = image.getColorModel();
        int space = model.getColorSpace().getType();
        // Java's conversion of grey to RGB gives colours that are brighter than the file's values
        grey = space == ColorSpace.TYPE_GRAY;
        inks = space == ColorSpace.TYPE_CMYK && !(model instanceof IndexColorModel);
        direct = (grey || space == ColorSpace.TYPE_RGB) && !(model instanceof IndexColorModel);
        if (isFloating()) {
            requireNumbers();
        }
    }

    private boolean isFloating() {
        return model.getTransferType() == DataBuffer.TYPE_FLOAT || model.getTransferType() == DataBuffer.TYPE_DOUBLE;
    }

    private void requireNumbers() throws IOException {
        double[] row = null;
        for (int y = 0; y < image.getHeight(); y++) {
            row = samples.getPixels(0, y, image.getWidth(), 1, row);
            for (double value : row) {
                if (!Double.isFinite((float) value)) {
                    throw new IOException("one with values that are no numbers");
                }
            }
        }
    }

    /** @throws IOException if the image cannot be read; the message says what was found instead of an image */
    static ImageFile read(ImageSource source) throws IOException {
        try (ImageInputStream in = source.content().isPresent()
                ? new MemoryCacheImageInputStream(stream(source.content().get()))
                : ImageIO.createImageInputStream(Path.of(source.name()).toFile())) {
            Iterator<ImageReader> readers = in == null ? null : ImageIO.getImageReaders(in);
            if (readers == null || !readers.hasNext()) {
                throw new IOException(in == null ? "a file that cannot be read" : "a format that is not known");
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(in);
                int step = step(reader.getWidth(0), reader.getHeight(0));
                ImageReadParam param = reader.getDefaultReadParam();
                param.setSourceSubsampling(step, step, 0, 0);
                return new ImageFile(reader.read(0, param), step);
            } catch (RuntimeException e) {
                throw new IOException("a broken one (" + e.getMessage() + ")", e);
            } finally {
                reader.dispose();
            }
        }
    }

    /**
     * The smallest step along rows and columns with which at most {@link #MOST_PIXELS} pixels are read of an image.
     *
     * @throws IOException if the image is too large to be read, or its rows or columns are, of which one is held whole
     */
    private static int step(int width, int height) throws IOException {
        if ((long) width * height > MOST_IN_FILE || Math.max(width, height) > MOST_PIXELS) {
            throw new IOException("one of " + width + "x" + height + " pixels, more than "
                    + ((long) width * height > MOST_IN_FILE ? MOST_IN_FILE : MOST_PIXELS + " along one side"));
        }
        int step = 1;
        while (((long) width + step - 1) / step * ((height + step - 1) / step) > MOST_PIXELS) {
            step++;
        }
        return step;
    }

    private static InputStream stream(ByteBuffer content) {
        byte[] bytes = new byte[content.remaining()];
        content.duplicate().get(bytes);
        return new ByteArrayInputStream(bytes);
    }

    /** 1 where all pixels were read; n where only every n-th pixel of every n-th row was. */
    int step() {
        return step;
    }

    int width() {
        return image.getWidth();
    }

    int height() {
        return image.getHeight();
    }

    /**
     * The value of a channel at a pixel.
     *
     * @param channel 0 red, 1 green, 2 blue
     * @param mean    whether to take the mean of the three channels instead
     * @param srgb    whether to make the value linear
     */
    double value(int x, int y, int channel, boolean mean, boolean srgb) {
        return mean ? (value(x, y, 0, srgb) + value(x, y, 1, srgb) + value(x, y, 2, srgb)) / 3
                : value(x, y, channel, srgb);
    }

    private double value(int x, int y, int channel, boolean srgb) {
        double code = direct ? uncovered(x, y, grey ? 0 : channel)
                : inks ? (1 - sample(x, y, channel)) * (1 - sample(x, y, 3))
                : (image.getRGB(x, y) >> 16 - 8 * channel & 0xFF) / 255.0;
        return srgb ? Srgb.linear(code) : code;
    }

    /** The value of a band, divided by alpha (the last band) if the image's colours are multiplied by alpha. */
    private double uncovered(int x, int y, int band) {
        double value = sample(x, y, band);
        double alpha = model.isAlphaPremultiplied() && model.hasAlpha() ? sample(x, y, model.getNumComponents() - 1)
                : 1;
        return alpha > 0 ? value / alpha : 0;
    }

    private double sample(int x, int y, int band) {
        if (isFloating()) {
            return samples.getSampleDouble(x, y, band);
        }
        if (model.getTransferType() == DataBuffer.TYPE_SHORT) {
            return Math.max(0, samples.getSample(x, y, band)) / (double) Short.MAX_VALUE;
        }
        long largest = (1L << model.getComponentSize(band)) - 1;
        return (samples.getSample(x, y, band) & largest) / (double) largest;
    }
}
