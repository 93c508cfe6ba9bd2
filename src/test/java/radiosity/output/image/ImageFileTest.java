package radiosity.output.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.scene.ImageSource;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Every kind of image has the values that were put into its samples. */
class ImageFileTest {

    private static final int GREY = ColorSpace.CS_GRAY;
    private static final int RGB = ColorSpace.CS_sRGB;
    private static final int LINEAR = ColorSpace.CS_LINEAR_RGB;

    @TempDir
    Path folder;

    /** One pixel with these samples, as one of each type: a whole number, or the float itself. */
    private static BufferedImage pixel(int space, int type, boolean alpha, boolean premultiplied, double... samples) {
        ColorModel model = new ComponentColorModel(ColorSpace.getInstance(space), alpha, premultiplied,
                alpha ? Transparency.TRANSLUCENT : Transparency.OPAQUE, type);
        WritableRaster raster = model.createCompatibleWritableRaster(1, 1);
        for (int b = 0; b < raster.getNumBands(); b++) {
            if (type == DataBuffer.TYPE_INT) {
                raster.setSample(0, 0, b, (int) (long) samples[b]);
            } else {
                raster.setSample(0, 0, b, samples[b]);
            }
        }
        return new BufferedImage(model, raster, premultiplied, null);
    }

    private static void assertValues(BufferedImage image, double r, double g, double b) throws IOException {
        ImageFile file = new ImageFile(image);
        assertEquals(r, file.value(0, 0, 0, false, false), 1e-7);
        assertEquals(g, file.value(0, 0, 1, false, false), 1e-7);
        assertEquals(b, file.value(0, 0, 2, false, false), 1e-7);
    }

    /** Four inks; how Java would turn them to RGB must not matter. */
    private static final class Inks extends ColorSpace {

        Inks() {
            super(TYPE_CMYK, 4);
        }

        @Override
        public float[] toRGB(float[] value) {
            return new float[3];
        }

        @Override
        public float[] fromRGB(float[] value) {
            return new float[4];
        }

        @Override
        public float[] toCIEXYZ(float[] value) {
            return new float[3];
        }

        @Override
        public float[] fromCIEXYZ(float[] value) {
            return new float[4];
        }
    }

    @Test
    void inks_takeTheirPartOfWhite() throws IOException {
        ColorModel model = new ComponentColorModel(new Inks(), false, false, Transparency.OPAQUE, DataBuffer.TYPE_BYTE);
        WritableRaster raster = model.createCompatibleWritableRaster(1, 1);
        raster.setPixel(0, 0, new int[] {51, 102, 0, 51});
        assertValues(new BufferedImage(model, raster, false, null), .8 * .8, .6 * .8, .8);
    }

    @ParameterizedTest
    @CsvSource({DataBuffer.TYPE_BYTE + ",255", DataBuffer.TYPE_USHORT + ",65535", DataBuffer.TYPE_SHORT + ",32767",
        DataBuffer.TYPE_INT + ",4294967295", DataBuffer.TYPE_FLOAT + ",1", DataBuffer.TYPE_DOUBLE + ",1"})
    void samplesOfEveryType_areTheirPartOfTheLargest(int type, double most) throws IOException {
        boolean whole = most > 1;
        double[] value = new double[4];
        double[] sample = new double[4];
        for (int i = 0; i < 4; i++) {
            sample[i] = whole ? Math.rint((0.2 + 0.2 * i) * most) : 0.2 + 0.2 * i;
            value[i] = sample[i] / most;
        }
        assertValues(pixel(GREY, type, false, false, sample[3]), value[3], value[3], value[3]);
        assertValues(pixel(RGB, type, false, false, sample), value[0], value[1], value[2]);
        assertValues(pixel(LINEAR, type, false, false, sample), value[0], value[1], value[2]);
        assertValues(pixel(GREY, type, true, false, sample[1], sample[2]), value[1], value[1], value[1]);
        assertValues(pixel(RGB, type, true, false, sample), value[0], value[1], value[2]);
    }

    /** Of half covered pixels, as whole numbers of which the colour can be found without rounding. */
    @Test
    void samplesMultipliedByAlpha_areDividedByIt() throws IOException {
        int type = DataBuffer.TYPE_BYTE;
        assertValues(pixel(GREY, type, true, true, 51, 102), .5, .5, .5);
        assertValues(pixel(RGB, type, true, true, 51, 102, 0, 102), .5, 1, 0);
        assertValues(pixel(RGB, DataBuffer.TYPE_FLOAT, true, true, .1, .3, .4, .5), .2, .6, .8);
        assertValues(pixel(RGB, type, true, true, 0, 0, 0, 0), 0, 0, 0);
    }

    @Test
    void floatsBeyondOne_stayThemselves() throws IOException {
        assertValues(pixel(RGB, DataBuffer.TYPE_FLOAT, false, false, 0, 12.5, 1e6), 0, 12.5, 1e6);
    }

    @Test
    void floatsThatAreNoNumbers_areRefused() {
        for (double wrong : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            assertEquals("one with values that are no numbers", assertThrows(IOException.class,
                    () -> new ImageFile(pixel(GREY, DataBuffer.TYPE_FLOAT, false, false, wrong))).getMessage());
        }
    }

    @Test
    void numberedColours_areTheColours() throws IOException {
        byte[] part = {0, 51, (byte) 255};
        IndexColorModel model = new IndexColorModel(8, 3, part, new byte[] {9, 102, 9}, new byte[] {9, (byte) 204, 9},
                new byte[] {9, 127, 9});
        BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_INDEXED, model);
        image.getRaster().setSample(0, 0, 0, 1);
        assertValues(image, .2, .4, .8);
    }

    @Test
    void packedColoursOfFiveAndSixBits_areTheirPartOfTheLargest() throws IOException {
        BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_USHORT_565_RGB);
        image.getRaster().setPixel(0, 0, new int[] {10, 21, 31});
        assertValues(image, 10 / 31.0, 21 / 63.0, 1);
    }

    @Test
    void floatsInATiffFile_areNotBlack() throws IOException {
        Path file = folder.resolve("float.tiff");
        assertTrue(ImageIO.write(pixel(GREY, DataBuffer.TYPE_FLOAT, false, false, .5), "tiff", file.toFile()));
        assertEquals(.5, ImageFile.read(ImageSource.file(file.toString())).value(0, 0, 0, false, false), 1e-7);
    }
}
