package radiosity.output.image;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.UnaryOperator;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import radiosity.output.file.AtomicFile;
import radiosity.scene.Rgb;
import radiosity.scene.Units;
import radiosity.util.ArraySize;

/** The formats in which pictures are written. */
public enum PictureFormat {

    /** Linear light in [0, 1], stored as 8-bit sRGB without loss. */
    PNG {
        @Override
        byte[] bytes(Picture picture, Units units) throws IOException {
            return png(picture, UnaryOperator.identity());
        }
    },
    /** Linear light in [0, 1], stored as 8-bit sRGB with quality 0.95. */
    JPEG {
        @Override
        byte[] bytes(Picture picture, Units units) throws IOException {
            return encoded(picture, UnaryOperator.identity(), "jpeg");
        }
    },
    /** Any light of at least 0, stored as Radiance's RGBE with 8-bit mantissas, not compressed. */
    HDR {
        @Override
        byte[] bytes(Picture picture, Units units) {
            return rgbe(picture, units);
        }
    };

    private static final float QUALITY = 0.95f;

    /**
     * The format that the end of a file's name stands for.
     *
     * @throws IOException if the name ends in neither .png, .jpg, .jpeg nor .hdr
     */
    public static PictureFormat of(Path file) throws IOException {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        return switch (name.substring(name.lastIndexOf('.') + 1)) {
            case "png" -> PNG;
            case "jpg", "jpeg" -> JPEG;
            case "hdr" -> HDR;
            default -> throw new IOException(file + ": expected a name that ends in .png, .jpg or .hdr, got "
                    + file.getFileName());
        };
    }

    /** @param units of the picture's light, for formats that name them */
    abstract byte[] bytes(Picture picture, Units units) throws IOException;

    /** Writes a picture, which replaces the file if there is one. */
    void write(Path file, Picture picture, Units units) throws IOException {
        AtomicFile.write(file, bytes(picture, units));
    }

    /**
     * Encodes a picture as PNG.
     *
     * @param film maps the light of the picture to linear light in [0, 1]
     */
    public static byte[] png(Picture picture, UnaryOperator<Rgb> film) throws IOException {
        return encoded(picture, film, "png");
    }

    /** Encodes an image as PNG. */
    public static byte[] png(BufferedImage image) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        // ImageIO's usual stream has a temporary file, which cannot be made any more while the program ends
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            ImageIO.write(image, "png", out);
        }
        return bytes.toByteArray();
    }

    private static byte[] encoded(Picture picture, UnaryOperator<Rgb> film, String format) throws IOException {
        BufferedImage image = new BufferedImage(picture.width(), picture.height(), BufferedImage.TYPE_INT_RGB);
        float[] rgb = picture.rgb();
        for (int i = 0; i < rgb.length / 3; i++) {
            Rgb light = film.apply(new Rgb(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]));
            image.setRGB(i % picture.width(), i / picture.width(), ToneMapping.srgb((float) light.r()) << 16
                    | ToneMapping.srgb((float) light.g()) << 8 | ToneMapping.srgb((float) light.b()));
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageWriter writer = ImageIO.getImageWritersByFormatName(format).next();
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            ImageWriteParam param = writer.getDefaultWriteParam();
            if (format.equals("jpeg")) {
                param.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
                param.setCompressionQuality(QUALITY);
            }
            writer.setOutput(out);
            writer.write(null, new IIOImage(image, null, null), param);
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }

    /** Encodes a picture as Radiance's RGBE: G. Ward, Real pixels, Graphics Gems II, 1991. */
    private static byte[] rgbe(Picture picture, Units units) {
        byte[] header = ("#?RADIANCE\n# radiosity, " + units.exitance() + "\nFORMAT=32-bit_rle_rgbe\n\n-Y "
                + picture.height() + " +X " + picture.width() + "\n").getBytes(StandardCharsets.US_ASCII);
        ByteBuffer bytes = ByteBuffer.allocate(ArraySize.of("bytes of a picture of " + picture.width() + "x"
                + picture.height() + " pixels", header.length + 4L * picture.width() * picture.height())).put(header);
        float[] rgb = picture.rgb();
        for (int i = 0; i < rgb.length; i += 3) {
            float most = Math.max(rgb[i], Math.max(rgb[i + 1], rgb[i + 2]));
            int exponent = Math.max(-127, Math.min(127, Math.getExponent(most) + 1));
            for (int c = 0; c < 3; c++) {
                bytes.put((byte) Math.max(0, Math.min(255, Math.scalb(rgb[i + c], 8 - exponent))));
            }
            bytes.put((byte) (most > 0 && exponent > -127 ? exponent + 128 : 0));
        }
        return bytes.array();
    }
}
