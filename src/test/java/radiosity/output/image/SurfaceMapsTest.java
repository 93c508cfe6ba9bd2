package radiosity.output.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.output.gltf.LitScene;
import radiosity.output.mesh.Mesh;
import radiosity.scene.ImageMap;
import radiosity.scene.ImageMap.Target;
import radiosity.scene.ImageMap.Wrap;
import radiosity.scene.ImageSource;
import radiosity.scene.MaterialSample;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** Images of surfaces: the left half red, the right half blue, on a square of 1. */
class SurfaceMapsTest {

    private static final Vec3 LEFT = new Vec3(.25, .5, 0);
    private static final Vec3 RIGHT = new Vec3(.75, .5, 0);

    @TempDir
    Path folder;

    private final List<String> told = new ArrayList<>();

    private Path image(String format, int type) throws IOException {
        BufferedImage image = new BufferedImage(8, 16, type);
        for (int i = 0; i < 128; i++) {
            image.setRGB(i % 8, i / 8, i % 8 < 4 ? 0xFFFF0000 : 0xFF0000FF);
        }
        Path file = folder.resolve("image." + format);
        assertTrue(ImageIO.write(image, format, file.toFile()), "a writer for " + format);
        return file;
    }

    private static ImageMap map(Path file, Target target, double scale, double opacity) {
        return new ImageMap(target, ImageSource.file(file.toString()), Rgb.grey(scale), false, false, false, opacity,
                Wrap.EDGE, Wrap.EDGE);
    }

    /** A square whose texture coordinates are x and y. */
    private Scene square(ImageMap... maps) {
        Surface surface = new Surface("painted", Rgb.grey(1), Rgb.grey(.4), false, List.of(maps));
        Scene scene = new Scene("square", new double[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0},
                new int[] {0, 1, 2, 0, 2, 3},
                new int[] {0, 0}, List.of(surface), List.of(), Optional.empty(),
                new float[] {0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1});
        return SurfaceMaps.read(scene, false, told::add);
    }

    private static int triangle(Vec3 p) {
        return p.x() > p.y() ? 0 : 1;
    }

    private static MaterialSample look(Scene scene, Vec3 p) {
        return scene.material(triangle(p), p);
    }

    private static void assertRgb(double r, double g, double b, Rgb got) {
        assertEquals(r, got.r(), 1e-6);
        assertEquals(g, got.g(), 1e-6);
        assertEquals(b, got.b(), 1e-6);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp", "gif", "tiff", "tga", "iff"})
    void commonFormats_areRead(String format) throws IOException {
        int type = format.equals("gif") ? BufferedImage.TYPE_BYTE_INDEXED : BufferedImage.TYPE_3BYTE_BGR;
        Scene scene = square(map(image(format, type), Target.REFLECTANCE, .8, 1));
        assertEquals(List.of(), told);
        assertRgb(.8, 0, 0, look(scene, LEFT).reflectance());
        assertRgb(0, 0, .8, look(scene, RIGHT).reflectance());
        assertRgb(1, 1, 1, look(scene, RIGHT).exitance());
        assertRgb(.4, 0, .4, scene.surfaces().get(0).reflectance());
    }

    /** One very wide, one very high: as many pixels as both have would be needed along each axis. */
    @Test
    void imagesThatTogetherAreTooLarge_leaveTheBaseColour() throws IOException {
        Path wide = folder.resolve("wide.png");
        Path high = folder.resolve("high.png");
        ImageIO.write(new BufferedImage(40_000, 1, BufferedImage.TYPE_BYTE_GRAY), "png", wide.toFile());
        ImageIO.write(new BufferedImage(1, 40_000, BufferedImage.TYPE_BYTE_GRAY), "png", high.toFile());
        Scene scene = square(map(wide, Target.REFLECTANCE, 1, 1), map(high, Target.REFLECTANCE, 1, 1));
        assertEquals(List.of("surface painted: expected images that together are at most 67108864 pixels, got"
                + " 40000x40000; the base colour is taken, a light grey where it is white"), told);
        assertRgb(.4, .4, .4, look(scene, LEFT).reflectance());
    }

    /** As of a LightWave surface of colour 1, 0, 0, or of diffuse 0, with images of colour and of diffuse. */
    @Test
    void imagesOfFactorsThatAre0WithoutThem_areMultiplied() throws IOException {
        Path red = image("png", BufferedImage.TYPE_INT_RGB);
        Path grey = folder.resolve("grey.png");
        BufferedImage half = new BufferedImage(2, 2, BufferedImage.TYPE_BYTE_GRAY);
        half.getRaster().setSamples(0, 0, 2, 2, 0, new int[] {51, 51, 51, 51});
        ImageIO.write(half, "png", grey.toFile());
        ImageMap colour = map(red, Target.REFLECTANCE, 0, 1);
        ImageMap diffuse = new ImageMap(Target.REFLECTANCE, ImageSource.file(grey.toString()), new Rgb(1, 0, 0), true,
                false, false, 1, Wrap.EDGE, Wrap.EDGE);
        Surface surface = new Surface("painted", Rgb.BLACK, Rgb.BLACK, false, List.of(colour, diffuse));
        Scene bare = square();
        Scene scene = SurfaceMaps.read(bare.with(List.of(surface), List.of()), false, told::add);
        assertRgb(.2, 0, 0, look(scene, LEFT).reflectance());
        assertRgb(0, 0, .2, look(scene, RIGHT).reflectance());
    }

    /** Images of a room are many, and each is needed for its surfaces alone. */
    @Test
    void imagesThatAreNotUsedAgain_areForgotten() throws IOException {
        Path file = image("png", BufferedImage.TYPE_INT_RGB);
        ImageMap once = map(file, Target.REFLECTANCE, .8, 1);
        Surface surface = new Surface("painted", Rgb.grey(1), Rgb.grey(.4), false, List.of(once,
                map(file, Target.EXITANCE, 1, 1)));
        SurfaceMaps maps = new SurfaceMaps(false, told::add);
        Scene scene = maps.read(square().with(List.of(surface, surface, surface), List.of()));
        assertEquals(0, maps.images());
        assertRgb(.8, 0, 0, look(scene, LEFT).reflectance());
    }

    /** There may be many megabytes of it. */
    @Test
    void contentOfAnImage_isNotRead_whereImagesAreToldApartByTheirNames() {
        ImageSource image = new ImageSource("a", Optional.of(ByteBuffer.wrap(new byte[] {1, 2})));
        assertEquals(image.hashCode(), new ImageSource("a", Optional.of(ByteBuffer.wrap(new byte[] {3}))).hashCode());
        assertEquals(image, new ImageSource("a", Optional.of(ByteBuffer.wrap(new byte[] {1, 2}))));
    }

    @Test
    void opacity_mixesWithTheBase() throws IOException {
        Scene scene = square(map(image("png", BufferedImage.TYPE_INT_RGB), Target.EXITANCE, 5, .5));
        assertRgb(3, .5, .5, look(scene, LEFT).exitance());
        assertRgb(.4, .4, .4, look(scene, LEFT).reflectance());
    }

    @Test
    void meanUnderAnElement_isOfItsPixels() throws IOException {
        Scene scene = square(map(image("png", BufferedImage.TYPE_INT_RGB), Target.REFLECTANCE, .8, 1));
        MaterialSample lower = scene.meanMaterial(0, Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(1, 1, 0));
        assertEquals(.8 / 4, lower.reflectance().r(), .02, "a quarter of the lower triangle lies to the left");
        assertEquals(.8 * 3 / 4, lower.reflectance().b(), .02);
    }

    @Test
    void unlitScene_hasTheMeanOfTheImageOnEachTriangle() throws IOException {
        Mesh mesh = LitScene.unlit(square(map(image("png", BufferedImage.TYPE_INT_RGB), Target.REFLECTANCE, .8, 1)))
                .meshes().get(0);
        assertEquals(3, mesh.reflectance(0, 0).b() / mesh.reflectance(0, 0).r(), .3,
                "the lower triangle is mostly blue");
        assertEquals(3, mesh.reflectance(1, 0).r() / mesh.reflectance(1, 0).b(), .3, "the upper one red");
    }

    @Test
    void grey_isWhatTheFileSays() throws IOException {
        BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_GRAY);
        image.getRaster().setSample(0, 0, 0, 51);
        Path file = folder.resolve("grey.png");
        ImageIO.write(image, "png", file.toFile());
        assertRgb(.2, .2, .2, look(square(map(file, Target.REFLECTANCE, 1, 1)), LEFT).reflectance());
    }

    @Test
    void whiteImage_reflectsLessThanAll() throws IOException {
        Scene scene = square(map(image("png", BufferedImage.TYPE_INT_RGB), Target.REFLECTANCE, 7, 1));
        assertEquals(Surface.MAX_REFLECTANCE, look(scene, LEFT).reflectance().r(), 1e-6);
    }

    @Test
    void imageThatCannotBeRead_leavesTheBaseAndIsTold() throws IOException {
        Path broken = Files.write(folder.resolve("broken.png"),
                new byte[] {(byte) 137, 'P', 'N', 'G', 13, 10, 26, 10, 0});
        Path absent = folder.resolve("absent.png");
        Scene scene = square(map(broken, Target.REFLECTANCE, .8, 1), map(absent, Target.EXITANCE, .8, 1));
        assertRgb(.4, .4, .4, look(scene, LEFT).reflectance());
        assertRgb(1, 1, 1, look(scene, LEFT).exitance());
        assertEquals(2, told.size(), told::toString);
        for (String line : told) {
            assertTrue(line.matches("\\S*(broken|absent).png: expected an image, got [^\\n]*; the base colour is taken,"
                    + " a light grey where it is white"), line);
        }
    }

    /** In glTF the base colour is 1 where an image gives it: a room of such surfaces would hardly lose light. */
    @Test
    void whiteUnderAnImageThatCannotBeRead_isALightGrey() throws IOException {
        ImageMap map = map(folder.resolve("absent.png"), Target.REFLECTANCE, 1, 1);
        Surface white = new Surface("white", Rgb.BLACK, Rgb.grey(Surface.MAX_REFLECTANCE), false, List.of(map));
        Surface red = new Surface("red", Rgb.BLACK, new Rgb(.9, .1, .1), false, List.of(map));
        List<Surface> read = SurfaceMaps.read(square().with(List.of(white, red), List.of()), false, told::add)
                .surfaces();
        assertRgb(.8, .8, .8, read.get(0).reflectance());
        assertRgb(.9, .1, .1, read.get(1).reflectance());
    }

    /** As programs write that put a scan's photographs into one image. */
    @Test
    void imageOfTooManyPixels_isReadInPart() throws IOException {
        BufferedImage image = new BufferedImage(8200, 8200, BufferedImage.TYPE_BYTE_BINARY);
        image.createGraphics().fillRect(4100, 0, 4100, 8200);
        Path file = folder.resolve("large.png");
        ImageIO.write(image, "png", file.toFile());
        Scene scene = square(map(file, Target.REFLECTANCE, .8, 1));
        assertEquals(List.of(file + ": expected at most 67108864 pixels, got more; one of 2 pixels along rows and"
                + " columns is taken"), told);
        assertEquals(4100 * 4100, scene.surfaces().get(0).maps().reflectance().orElseThrow().pixels());
        assertRgb(0, 0, 0, look(scene, LEFT).reflectance());
        assertRgb(.8, .8, .8, look(scene, RIGHT).reflectance());
    }

    /** The file of a few bytes claims to be that large. */
    @Test
    void imageOfFarTooManyPixels_isNotRead() throws IOException {
        Path file = image("png", BufferedImage.TYPE_3BYTE_BGR);
        byte[] bytes = Files.readAllBytes(file);
        ByteBuffer.wrap(bytes).putInt(16, 40_000).putInt(20, 40_000);
        Files.write(file, bytes);
        square(map(file, Target.REFLECTANCE, .8, 1));
        assertEquals(List.of(file + ": expected an image, got one of 40000x40000 pixels, more than 1073741824; the base"
                + " colour is taken, a light grey where it is white"), told);
    }
}
