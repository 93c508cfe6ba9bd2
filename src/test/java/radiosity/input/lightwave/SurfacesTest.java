package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.input.lightwave.Iff.chunk;
import static radiosity.input.lightwave.Iff.f4;
import static radiosity.input.lightwave.Iff.form;
import static radiosity.input.lightwave.Iff.s0;
import static radiosity.input.lightwave.Iff.sub;
import static radiosity.input.lightwave.Iff.u1;
import static radiosity.input.lightwave.Iff.u2;
import static radiosity.input.lightwave.Iff.u4;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Specular;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;
import radiosity.settings.ReadOptions.Emission;

/** What surfaces of every format come to. */
class SurfacesTest {

    @TempDir
    Path folder;

    private final List<String> told = new ArrayList<>();

    private Surface read(byte[] object, ReadOptions options) throws IOException {
        Path file = Files.write(folder.resolve("thing.lwo"), object);
        return LightWaveReader.read(file, options, told::add).surface(0);
    }

    private Surface read(byte[] object) throws IOException {
        return read(object, ReadOptions.defaults());
    }

    private static byte[] old(byte[]... parts) {
        return form("LWOB", chunk("PNTS", f4(Objects.CORNERS)), chunk("SRFS", s0("white")),
                chunk("POLS", u2(3, 0, 1, 2, 1)), chunk("SURF", s0("white"), Iff.join(parts)));
    }

    private static void assertClose(Rgb expected, Rgb got) {
        for (int c = 0; c < 3; c++) {
            assertEquals(expected.channel(c), got.channel(c), 1e-6, got.toString());
        }
    }

    @Test
    void oldObject_missingValuesAreZero() throws IOException {
        Surface lamp = read(old(sub("COLR", u1(255, 0, 51, 0)), sub("LUMI", u2(512))));
        assertClose(Rgb.BLACK, lamp.reflectance());
        assertClose(new Rgb(2, 0, 0.4), lamp.exitance());
    }

    @Test
    void oldObject_256isAll_andNumbersWithAPointWin() throws IOException {
        Surface half = read(old(sub("COLR", u1(255, 255, 255, 0)), sub("DIFF", u2(128))));
        assertClose(Rgb.grey(0.5), half.reflectance());
        Surface precise = read(old(sub("VDIF", f4(0.123)), sub("COLR", u1(255, 255, 255, 0)), sub("DIFF", u2(128))));
        assertClose(Rgb.grey(0.123), precise.reflectance());
    }

    @Test
    void oldObject_sharesOf4Bytes_areReadToo() throws IOException {
        byte[] object = old(sub("COLR", u1(255, 255, 255, 0)), sub("SPEC", u4(64)));
        assertClose(Rgb.grey(0.25), read(object, ReadOptions.defaults().withEmission(Emission.SPECULAR))
                .exitance());
    }

    @Test
    void smoothingAngle_isReadInEveryFormat() throws IOException {
        byte[] sman = sub("SMAN", f4(.75));
        assertEquals(.75, read(Objects.lwo2(Objects.lwo2Surface("white", "", sman))).smoothing());
        assertEquals(0, read(Objects.lwo2(Objects.lwo2Surface("white", "", sub("SMAN", f4(-1))))).smoothing());
        assertEquals(0, read(Objects.lwo2(Objects.lwo2Surface("white", "", sub("SMAN", f4(Double.NaN))))).smoothing());
        assertEquals(Math.PI, read(Objects.lwo2(Objects.lwo2Surface("white", "", sub("SMAN", f4(7))))).smoothing());
        assertEquals(0, read(Objects.lwo2(Objects.lwo2Surface("white", ""))).smoothing());
        assertEquals(.75, read(form("LWO3", chunk("TAGS", s0("white")), Objects.squareOf("FACE"),
                form("SURF", chunk("    ", s0("white"), s0("")), chunk("SMAN", f4(.75))))).smoothing());
        assertEquals(.75, read(old(sub("FLAG", u2(4)), sman)).smoothing());
        assertEquals(.75, read(old(sman, sub("FLAG", u2(4)))).smoothing());
        assertEquals(0, read(old(sub("FLAG", u2(1)), sman)).smoothing(), "the flag is not set");
        assertEquals(Math.toRadians(89.5), read(old(sub("FLAG", u2(4)))).smoothing(), 1e-12, "LightWave's usual angle");
        assertEquals(.75, read(old(sman)).smoothing(), "no flags");
        assertEquals(0, read(old()).smoothing());
    }

    @Test
    void twoSided_isReadInBothFormats() throws IOException {
        assertEquals(false, read(old(sub("FLAG", u2(4)))).twoSided());
        assertEquals(true, read(old(sub("FLAG", u2(0x104)))).twoSided());
        assertEquals(false, read(Objects.lwo2(Objects.lwo2Surface("white", "", sub("SIDE", u2(1))))).twoSided());
        assertEquals(true, read(Objects.lwo2(Objects.lwo2Surface("white", "", sub("SIDE", u2(3))))).twoSided());
    }

    @Test
    void newObject_missingValuesAreLightWavesOwn() throws IOException {
        Surface plain = read(Objects.lwo2(Objects.lwo2Surface("white", "")));
        assertClose(Rgb.grey(200 / 255.0), plain.reflectance());
        assertClose(Rgb.BLACK, plain.exitance());
    }

    @Test
    void surface_inheritsFromItsSource_throughOthers() throws IOException {
        Surface child = read(Objects.lwo2(Objects.lwo2Surface("white", "b", Objects.share("DIFF", 0.5)),
                Objects.lwo2Surface("b", "c", Objects.share("DIFF", 0.1)),
                Objects.lwo2Surface("c", "", Objects.colour(0.2, 0.4, 0.6), Objects.share("LUMI", 10))));
        assertClose(new Rgb(0.1, 0.2, 0.3), child.reflectance());
        assertClose(new Rgb(2, 4, 6), child.exitance());
    }

    @Test
    void principledMaterial_emitsInItsOwnColour() throws IOException {
        Surface surface = read(SoundFiles.lwo3());
        assertClose(new Rgb(0.25, 0.5, 0.75), surface.reflectance());
        assertClose(new Rgb(2, 1, 0), surface.exitance());
    }

    @Test
    void materialBehindAMixer_isFound() throws IOException {
        byte[] surface = form("SURF", chunk("    ", s0("white")), form("NODS", form("NNDS",
                SoundFiles.node("Surface", "Surface"), SoundFiles.node("Material Mixer", "mix"),
                SoundFiles.node("Standard", "s", SoundFiles.attribute("Color", 1, 0.5, 0),
                        SoundFiles.attribute("Diffuse",
                        0.5), SoundFiles.attribute("Luminosity", 3))), form("NCON",
                SoundFiles.link("Surface", "Material", "mix"), SoundFiles.link("mix", "A", "s"),
                SoundFiles.link("s", "Loop", "mix"))));
        Surface mixed = read(form("LWO3", chunk("TAGS", s0("white")), Objects.squareOf("FACE"), surface));
        assertClose(new Rgb(0.5, 0.25, 0), mixed.reflectance());
        assertClose(new Rgb(3, 1.5, 0), mixed.exitance());
    }

    @Test
    void srgb_makesColoursLinear() throws IOException {
        byte[] object = Objects.lwo2(Objects.lwo2Surface("white", "", Objects.colour(0.5, 0.04, 1),
                Objects.share("DIFF", 0.5)));
        Surface linear = read(object, ReadOptions.defaults().withSrgb(true));
        assertClose(new Rgb(0.5 * 0.2140411, 0.5 * 0.04 / 12.92, 0.5), linear.reflectance());
    }

    @Test
    void tooMuchReflectance_isClippedAndTold() throws IOException {
        Surface bright = read(Objects.lwo2(Objects.lwo2Surface("white", "", Objects.colour(1, 0.5, 0),
                Objects.share("DIFF", 1.5))));
        assertClose(new Rgb(Surface.MAX_REFLECTANCE, 0.75, 0), bright.reflectance());
        assertTrue(told.get(0).contains("0.9999"), told.toString());
    }

    @Test
    void surfacesOfOneName_areOneIfEqual_andCarryTheirObjectIfNot() throws IOException {
        Files.write(folder.resolve("a.lwo"), Objects.lwo2(Objects.lwo2Surface("white", "", Objects.share("DIFF", .5))));
        Files.write(folder.resolve("b.lwo"), Objects.lwo2(Objects.lwo2Surface("white", "", Objects.share("DIFF", .5))));
        Files.write(folder.resolve("c.lwo"), Objects.lwo2(Objects.lwo2Surface("white", "", Objects.share("DIFF", .7))));
        Files.createDirectory(folder.resolve("d"));
        Files.write(folder.resolve("d/c.lwo"),
                Objects.lwo2(Objects.lwo2Surface("white", "", Objects.share("DIFF", .9))));
        Path file = Files.writeString(folder.resolve("s.lws"), "LWSC\n1\nLoadObject a.lwo\nLoadObject b.lwo\n"
                + "LoadObject c.lwo\nLoadObject a.lwo\nLoadObject d/c.lwo\n");
        Scene scene = LightWaveReader.read(file, ReadOptions.defaults(), told::add);
        assertEquals(List.of("white", "c.lwo:white", "c.lwo:white#2"), scene.surfaces().stream().map(Surface::name)
                .toList());
        assertEquals(10, scene.triangles());
    }

    @Test
    void surfaceNamedLikeACopyOfAnother_isSteppedOver() throws IOException {
        List<String> names = List.of("\u0001\u0001", "thing.lwo:\\u0001\\u0001#3", "\\u0001\u0001",
                "\u0001\\u0001", "\\u0001\\u0001");
        byte[][] surfaces = new byte[names.size()][];
        byte[][] polygons = new byte[names.size()][];
        byte[][] tags = new byte[names.size()][];
        for (int i = 0; i < surfaces.length; i++) {
            surfaces[i] = Objects.lwo2Surface(names.get(i), "", Objects.share("DIFF", .1 * (i + 1)));
            polygons[i] = u2(3, 0, i + 1, i + 2);
            tags[i] = u2(i, i);
        }
        byte[] object = form("LWO2", chunk("TAGS", names.stream().map(Iff::s0).toArray(byte[][]::new)),
                chunk("PNTS", f4(0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5, 0)),
                chunk("POLS", Iff.text("FACE"), Iff.join(polygons)), chunk("PTAG", Iff.text("SURF"), Iff.join(tags)),
                        Iff.join(surfaces));
        Path file = Files.write(folder.resolve("thing.lwo"), object);
        Scene scene = assertTimeoutPreemptively(Duration.ofSeconds(30),
                () -> LightWaveReader.read(file, ReadOptions.defaults(), told::add));
        String plain = "\\u0001\\u0001";
        assertEquals(List.of(plain, "thing.lwo:" + plain + "#3", "thing.lwo:" + plain, "thing.lwo:" + plain + "#4",
                "thing.lwo:" + plain + "#5"), scene.surfaces().stream().map(Surface::name).toList());
    }

    @Test
    void strict_makesTheFirstWarningAnError() {
        byte[] object = Objects.lwo2(Objects.lwo2Surface("white", "", Objects.share("DIFF", 5)));
        SceneFormatException error = assertThrows(SceneFormatException.class,
                () -> read(object, ReadOptions.defaults().withStrict(true)));
        assertTrue(error.getMessage().contains("strict"), error.getMessage());
    }

    @Test
    void budgets_areOneLine() throws IOException {
        SceneFormatException triangles = assertThrows(SceneFormatException.class,
                () -> read(Objects.square(), ReadOptions.defaults().withMaxTriangles(1)));
        assertEquals("thing.lwo: expected at most 1 triangles, got 2", triangles.getMessage());
        SceneFormatException bytes = assertThrows(SceneFormatException.class,
                () -> read(Objects.square(), ReadOptions.defaults().withMaxBytes(100)));
        assertTrue(bytes.getMessage().startsWith("thing.lwo: expected at most 100 bytes, got "), bytes.getMessage());
    }

    private Specular specular(byte[]... parts) throws IOException {
        return read(Objects.lwo2(Objects.lwo2Surface("white", "", parts))).specular().orElseThrow();
    }

    @Test
    void whatIsNeitherMirrorNorGlass_doesNotShine() throws IOException {
        assertEquals(Optional.empty(), read(Objects.lwo2(Objects.lwo2Surface("white", "", Objects.share("SPEC", 1),
                Objects.share("GLOS", .8), Objects.share("RIND", 1.5)))).specular());
        assertEquals(Optional.empty(), read(old(sub("SPEC", u2(256)), sub("GLOS", u2(64)))).specular());
    }

    @Test
    void reflection_isAMirror_asBlurredAsItsHighlights() throws IOException {
        Specular mirror = specular(Objects.share("REFL", .5), Objects.share("RIND", 1.5));
        assertEquals(new Specular(Rgb.grey(.5), Rgb.BLACK, 1, 0, 1, false), mirror);
        Specular blurred = specular(Objects.share("REFL", .5), Objects.share("SPEC", .5));
        assertEquals(Math.pow(2. / (4 * 64 + 2), .25), blurred.roughness(), 1e-12, "40 % are the power of 64");
        assertEquals(.25, read(old(sub("REFL", u2(64)))).specular().orElseThrow().reflectance().g());
        Specular precise = read(old(sub("VRFL", f4(.125)), sub("REFL", u2(64)), sub("SPEC", u2(9)),
                sub("GLOS", u2(64)))).specular().orElseThrow();
        assertEquals(.125, precise.reflectance().g());
        assertEquals(blurred.roughness(), precise.roughness(), 1e-12);
    }

    @Test
    void transparency_isGlass_ofItsRefractiveIndex() throws IOException {
        Specular glass = specular(Objects.share("TRAN", .5), Objects.share("RIND", 1.5), Objects.share("REFL", .25),
                Objects.share("SPEC", 1));
        assertEquals(.25 + .75 * .04, glass.reflectance().r(), 1e-6);
        assertEquals(.5 * (1 - .28), glass.transmittance().r(), 1e-6);
        assertEquals(.5, glass.diffuse());
        assertEquals(1.5, glass.index());
        assertEquals(0, glass.roughness());
        assertEquals(false, glass.thin());
        assertEquals(true, specular(Objects.share("TRAN", 1), sub("SIDE", u2(3))).thin());
        assertTrue(told.contains("thing.lwo: transparent surfaces let no light through; pictures show what is behind"
                + " them: white"), told.toString());
        assertEquals(1.25, read(old(sub("TRAN", u2(256)), sub("RIND", f4(1.25)))).specular().orElseThrow().index());
    }

    @Test
    void hostileShine_isLimited() throws IOException {
        for (double index : new double[] {0, -1, Double.NaN, Double.NEGATIVE_INFINITY}) {
            assertEquals(1, specular(Objects.share("TRAN", 1), Objects.share("RIND", index)).index());
        }
        assertEquals(Specular.MOST_INDEX, specular(Objects.share("TRAN", 1), Objects.share("RIND", 1e30)).index());
        assertEquals(Specular.LEAST_INDEX, specular(Objects.share("TRAN", 1), Objects.share("RIND", 1e-30)).index());
        assertEquals(1, specular(Objects.share("REFL", 1e9), Objects.share("TRAN", Double.POSITIVE_INFINITY))
                .reflectance().b());
        assertEquals(1, specular(Objects.share("REFL", 1), Objects.share("SPEC", 1), Objects.share("GLOS", -1e9))
                .roughness(), .5);
        assertEquals(0, specular(Objects.share("REFL", 1), Objects.share("SPEC", 1), Objects.share("GLOS", 1e9))
                .roughness());
        assertEquals(Optional.empty(), read(Objects.lwo2(Objects.lwo2Surface("white", "",
                Objects.share("REFL", Double.NaN), Objects.share("TRAN", -1)))).specular());
    }
}
