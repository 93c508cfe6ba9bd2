package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.input.lightwave.Iff.chunk;
import static radiosity.input.lightwave.Iff.f4;
import static radiosity.input.lightwave.Iff.form;
import static radiosity.input.lightwave.Iff.s0;
import static radiosity.input.lightwave.Iff.sub;
import static radiosity.input.lightwave.Iff.text;
import static radiosity.input.lightwave.Iff.u1;
import static radiosity.input.lightwave.Iff.u2;
import static radiosity.input.lightwave.Iff.u4;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.scene.ImageMap;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.settings.ReadOptions;

/** Images on surfaces: which, what they vary, and where on them each corner lies. */
class TexturesTest {

    @TempDir
    Path folder;

    private final List<String> told = new ArrayList<>();

    @BeforeEach
    void layImages() throws IOException {
        Files.createDirectories(folder.resolve("Images"));
        Files.write(folder.resolve("Images/wood.png"), new byte[8]);
    }

    private Scene read(byte[] object) throws IOException {
        return LightWaveReader.read(Files.write(folder.resolve("thing.lwo"), object), ReadOptions.defaults(),
                told::add);
    }

    private static byte[] clip() {
        return chunk("CLIP", u4(1), sub("STIL", s0("C:\\pictures\\WOOD.PNG")));
    }

    private static byte[] object(byte[]... blocks) {
        return Objects.lwo2(clip(), Objects.lwo2Surface("white", "", Objects.colour(0.5, 0.25, 1),
                Objects.share("DIFF", 0.8), Objects.share("LUMI", 2), Iff.join(blocks)));
    }

    private static byte[] placed(double[] centre, double[] size) {
        return sub("TMAP", sub("CNTR", f4(centre), u2(0)), sub("SIZE", f4(size), u2(0)),
                sub("ROTA", f4(0, 0, 0), u2(0)));
    }

    /** Every corner of the scene by its place, u and v. */
    private static void assertCoordinates(Scene scene, double tolerance,
            java.util.function.UnaryOperator<double[]> uvOf) {
        for (int t = 0; t < scene.triangles(); t++) {
            for (int k = 0; k < 3; k++) {
                var p = scene.corner(t, k);
                double[] expected = uvOf.apply(new double[] {p.x(), p.y(), -p.z()});
                assertEquals(expected[0], scene.textureCoordinates()[6 * t + 2 * k], tolerance);
                assertEquals(expected[1], scene.textureCoordinates()[6 * t + 2 * k + 1], tolerance);
            }
        }
    }

    @Test
    void planarImage_liesByCentreAndSize() throws IOException {
        Scene scene = read(object(SoundFiles.imageBlock("COLR", 0, sub("AXIS", u2(2)),
                placed(new double[] {0.5, 0.25, 3}, new double[] {2, 4, 1}))));
        assertEquals(List.of(), told);
        assertCoordinates(scene, 1e-6, p -> new double[] {(p[0] - 0.5) / 2 + 0.5, (p[1] - 0.25) / 4 + 0.5});
    }

    @Test
    void colourImage_variesReflectanceAndTheLightOfItsColour() throws IOException {
        List<ImageMap> maps = read(object(SoundFiles.imageBlock("COLR", 0))).surfaces().get(0).textures();
        assertEquals(List.of(ImageMap.Target.REFLECTANCE, ImageMap.Target.EXITANCE),
                maps.stream().map(ImageMap::target).toList());
        assertEquals(0.8, maps.get(0).scale().g(), 1e-6);
        assertEquals(2, maps.get(1).scale().g(), 1e-6);
        assertTrue(maps.get(0).image().name().endsWith("wood.png"), maps.get(0).image().name());
    }

    @Test
    void luminosityAndDiffuseImages_scaleTheColour() throws IOException {
        List<ImageMap> maps = read(object(SoundFiles.imageBlock("LUMI", 0), SoundFiles.imageBlock("DIFF", 0)))
                .surfaces().get(0).textures();
        assertEquals(new ImageMap(ImageMap.Target.EXITANCE, maps.get(0).image(), new Rgb(0.5, 0.25, 1), true, false,
                false, 1, ImageMap.Wrap.REPEAT, ImageMap.Wrap.REPEAT), maps.get(0));
        assertEquals(ImageMap.Target.REFLECTANCE, maps.get(1).target());
    }

    /** A screen: its image says what colour shines where another image is bright. */
    @Test
    void luminosityImageOnASurfaceThatDoesNotShine_hasTheColourOfItsImage() throws IOException {
        List<ImageMap> maps = read(Objects.lwo2(clip(), Objects.lwo2Surface("white", "", Objects.colour(1, 0, 0),
                Objects.share("LUMI", 0), Iff.join(SoundFiles.imageBlock("COLR", 0), SoundFiles.imageBlock("LUMI", 0)))))
                .surfaces().get(0).textures();
        assertEquals(2, maps.stream().filter(map -> map.target() == ImageMap.Target.EXITANCE).count());
        assertEquals(3, maps.size());
    }

    /** One repeats, the other ends at its edges. */
    @Test
    void imagesThatGoOnOtherwise_areToldAsThoseThatLieOtherwise() throws IOException {
        assertEquals(1, read(object(SoundFiles.imageBlock("COLR", 0),
                SoundFiles.imageBlock("DIFF", 0, sub("WRAP", u2(0, 0))))).surfaces().get(0).textures().stream()
                .filter(map -> map.target() == ImageMap.Target.REFLECTANCE).count());
        assertTrue(told.get(0).contains("lie otherwise"), told.toString());
    }

    @Test
    void uvImage_takesPoints_andCornersOverThem() throws IOException {
        Scene scene = read(SoundFiles.texturedLwo2());
        assertCoordinates(scene, 1e-6, p -> p[0] == 1 && p[1] == 1 ? new double[] {0.5, 0.25}
                : new double[] {p[0], p[1]});
    }

    @Test
    void sphericalImage_growsWithTheAngle_andIsNotTornAtItsSeam() throws IOException {
        Scene scene = read(object(SoundFiles.imageBlock("COLR", 2, sub("AXIS", u2(1)),
                placed(new double[] {0.5, 0.5, 2}, new double[] {1, 1, 1}))));
        for (int t = 0; t < 2; t++) {
            for (int k = 0; k < 3; k++) {
                double x = scene.corner(t, k).x() - 0.5;
                double y = scene.corner(t, k).y() - 0.5;
                double u = scene.textureCoordinates()[6 * t + 2 * k];
                double v = scene.textureCoordinates()[6 * t + 2 * k + 1];
                assertEquals(Math.atan2(x, 2) / (2 * Math.PI), Math.IEEEremainder(u - 0.5, 1), 1e-6);
                assertEquals(0.5 + Math.atan2(y, Math.hypot(x, 2)) / Math.PI, v, 1e-6);
                assertTrue(Math.abs(u - scene.textureCoordinates()[6 * t]) <= 0.5, "torn");
            }
        }
    }

    /** Angles are those of the object; the size counts along a cylinder's axis. */
    @Test
    void sizeOfARoundImage_changesNoAngle() throws IOException {
        for (int projection : new int[] {1, 2}) {
            Scene plain = read(object(SoundFiles.imageBlock("COLR", projection, sub("AXIS", u2(1)),
                    placed(new double[] {0.5, 0.5, 2}, new double[] {1, 1, 1}))));
            Scene sized = read(object(SoundFiles.imageBlock("COLR", projection, sub("AXIS", u2(1)),
                    placed(new double[] {0.5, 0.5, 2}, new double[] {4, 2, .5}))));
            for (int i = 0; i < 12; i++) {
                double expected = plain.textureCoordinates()[i];
                boolean isHeight = projection == 1 && i % 2 == 1;
                assertEquals(isHeight ? .5 + (expected - .5) / 2 : expected, sized.textureCoordinates()[i], 1e-6);
            }
        }
    }

    @Test
    void imagesOnTransparency_areLeftOutWithAWarning() throws IOException {
        read(object(SoundFiles.imageBlock("TRAN", 0)));
        assertTrue(told.get(0).contains("images on transparency and reflection are left out"), told.toString());
    }

    @Test
    void cubicImage_isPlanarAcrossTheFace() throws IOException {
        Scene scene = read(object(SoundFiles.imageBlock("COLR", 3, sub("AXIS", u2(0)))));
        assertCoordinates(scene, 1e-6, p -> new double[] {p[0] + 0.5, p[1] + 0.5});
    }

    @Test
    void oldImage_isReadWithItsFlags() throws IOException {
        Scene scene = read(form("LWOB", chunk("PNTS", f4(Objects.CORNERS)), chunk("SRFS", s0("white")),
                chunk("POLS", u2(3, 0, 1, 2, 1)), chunk("SURF", s0("white"), sub("COLR", u1(255, 255, 255, 0)),
                        sub("DIFF", u2(256)), sub("CTEX", s0("Planar Image Map")), sub("TFLG", u2(4 | 16)),
                        sub("TSIZ", f4(2, 2, 2)), sub("TIMG", s0("Work:wood.png")), sub("TWRP", u2(1, 3)))));
        assertCoordinates(scene, 1e-6, p -> new double[] {p[0] / 2 + 0.5, p[1] / 2 + 0.5});
        ImageMap map = scene.surfaces().get(0).textures().get(0);
        assertTrue(map.negative());
        assertEquals(List.of(ImageMap.Wrap.EDGE, ImageMap.Wrap.MIRROR), List.of(map.wrapU(), map.wrapV()));
    }

    /** As LightWave's surface editor writes images, where no node editor was used. */
    @Test
    void layerOnAnInputOfLwo3_isReadAsABlock() throws IOException {
        byte[] layer = form("TXTR", form("BLOK",
                form("IMAP", chunk("    ", u1(0x80, 0)), chunk("CHAN", text("txtr")), form("OPAC",
                        chunk("    ", u2(0), f4(.5), u4(0))), chunk("ENAB", u2(1)), chunk("NEGA", u2(1))),
                form("TMAP", form("CNTR", chunk("    ", f4(.5, .25, 3), u2(0))),
                        form("SIZE", chunk("    ", f4(2, 4, 1), u2(0))), chunk("CSYS", u2(0))),
                chunk("PROJ", u2(0)), chunk("AXIS", u2(2)), chunk("IMAG", u2(7)), chunk("WRAP", u2(2, 0))));
        byte[] colour = form("ENTR", chunk("NAME", s0("Color")), form("VALU", chunk("    ", s0("vparam")),
                form("VALU", chunk("    ", u4(3), Iff.f8(1, .5, .25))), layer));
        Scene scene = read(form("LWO3", chunk("TAGS", s0("white")), Objects.squareOf("FACE"),
                form("CLIP", chunk("    ", u4(7)), form("STIL", chunk("    ", s0("wood.png")))),
                form("SURF", chunk("    ", s0("white")), form("NODS", form("NNDS", SoundFiles.node("Surface", "Surface"),
                        SoundFiles.node("Standard", "m", colour, SoundFiles.attribute("Diffuse", .5))), form("NCON",
                        SoundFiles.link("Surface", "Material", "m"))))));
        assertEquals(List.of(), told);
        ImageMap map = scene.surfaces().get(0).textures().get(0);
        assertEquals(ImageMap.Target.REFLECTANCE, map.target());
        assertTrue(map.negative() && map.image().name().endsWith("wood.png"), map.toString());
        assertEquals(.5, map.opacity(), 1e-6);
        assertEquals(List.of(ImageMap.Wrap.MIRROR, ImageMap.Wrap.NONE), List.of(map.wrapU(), map.wrapV()));
        assertCoordinates(scene, 1e-6, p -> new double[] {(p[0] - .5) / 2 + .5, (p[1] - .25) / 4 + .5});
    }

    /** An object whose material has the image "wood.png" at some of its inputs. */
    private static byte[] imageNode(byte[]... links) {
        byte[] image = Iff.join(chunk("NSRV", s0("Image")), form("NTAG", chunk("NNME", s0("i")), form("NDTA",
                form("IIMG", form("CLIP", form("STIL", chunk("    ", s0("wood.png"))))), chunk("IMAP", u4(5)),
                chunk("IUVI", s0("map")), chunk("IUTL", u4(2)), chunk("IVTL", u4(0)))));
        byte[] surface = form("SURF", chunk("    ", s0("white")), form("NODS", form("NNDS",
                SoundFiles.node("Surface", "Surface"), SoundFiles.node("Standard", "s",
                        SoundFiles.attribute("Color", 1, 1, 1), SoundFiles.attribute("Diffuse", 0.5)), image),
                form("NCON", SoundFiles.link("Surface", "Material", "s"), Iff.join(links))));
        return form("LWO3", chunk("TAGS", s0("white")), Objects.squareOf("FACE"), chunk("VMAP", text("TXUV"),
                u2(2), s0("map"), u2(0), f4(0, 0), u2(1), f4(0, 1), u2(2), f4(1, 1)), surface);
    }

    /** What it does to the one is not what it does to the other. */
    @Test
    void imageNodeAtTwoInputs_variesBothQuantities() throws IOException {
        Scene scene = read(imageNode(SoundFiles.link("s", "Color", "i"), SoundFiles.link("s", "Luminosity", "i")));
        assertEquals(List.of(ImageMap.Target.REFLECTANCE, ImageMap.Target.EXITANCE),
                scene.surfaces().get(0).textures().stream().map(ImageMap::target).distinct().toList());
    }

    @Test
    void imageNode_isReadBesideItsMaterial() throws IOException {
        Scene scene = read(imageNode(SoundFiles.link("s", "Color", "i")));
        ImageMap map = scene.surfaces().get(0).textures().get(0);
        assertEquals(List.of(ImageMap.Wrap.MIRROR, ImageMap.Wrap.NONE), List.of(map.wrapU(), map.wrapV()));
        for (int t = 0; t < 2; t++) {
            int triangle = t;
            boolean isWhole = IntStream.range(0, 3).noneMatch(k -> scene.corner(triangle, k).x() == 1
                    && scene.corner(triangle, k).y() == 0);
            assertEquals(isWhole, scene.hasImages(t) || !Float.isNaN(scene.textureCoordinates()[6 * t]),
                    "a triangle with a corner that the map leaves out has the base colour");
        }
        assertTrue(Float.isNaN(scene.textureCoordinates()[0]) != Float.isNaN(scene.textureCoordinates()[6]));
    }

    @Test
    void missingImage_leavesTheBaseColour_andIsTold() throws IOException {
        Files.delete(folder.resolve("Images/wood.png"));
        Scene scene = read(object(SoundFiles.imageBlock("COLR", 0)));
        assertEquals(List.of(), scene.surfaces().get(0).textures());
        assertArrayEquals(new float[0], scene.textureCoordinates());
        assertTrue(told.get(0).contains("WOOD.PNG"), told.toString());
    }

    @Test
    void imagesThatLieOtherwise_areLeftOutAndTold() throws IOException {
        Scene scene = read(object(SoundFiles.imageBlock("COLR", 0),
                SoundFiles.imageBlock("DIFF", 0, sub("AXIS", u2(1)))));
        assertEquals(2, scene.surfaces().get(0).textures().size());
        assertTrue(told.get(0).contains("lie otherwise"), told.toString());
    }
}
