package radiosity.input.obj;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.scene.ImageMap;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.scene.Srgb;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

class ObjReaderTest {

    /** A square of side 2 and above it a smaller one. */
    private static final String SQUARES = """
            # two squares
            mtllib Room Materials.mtl
            v 0 0 0
            v 0 0 2
            v 2 0 2
            v 2 0 0
            o floor
            usemtl paint
            f 1 2 3 4
            o lamp
            v 0 3 0
            v 1 3 0
            v 1 3 1
            v 0 3 1
            usemtl glow
            f -4//-1 -3 -2 \\
              -1
            """;

    @TempDir
    Path folder;
    private final List<String> told = new ArrayList<>();

    private Scene read(String text, ReadOptions options) throws IOException {
        return ObjReader.read(Files.writeString(folder.resolve("room.obj"), text), options, told::add);
    }

    /** Two squares at a right angle and a third one bent by 45 degrees from the second. */
    private static String strip(String first, String second, String third) {
        return "v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nv 1 1 1\nv 1 1 0\nv 0 2 1\nv 0 2 0\nvn 1 0 0\nvn 0 1 0\n" + first
                + second + third;
    }

    private static void assertReflectances(Scene scene, double... expected) {
        double[] got = new double[expected.length];
        for (int i = 0; i < got.length; i++) {
            got[i] = scene.surfaces().get(scene.surfaceOf()[i / 9]).reflectance().channel(i % 3)
                    * (scene.vertexColours().length == 0 ? 1 : scene.vertexColours()[i]);
        }
        assertArrayEquals(expected, got, 1e-6);
    }

    /** One vertex with a weight alone, one with a colour, one with both. */
    @Test
    void coloursOfVertices_areReflectances_whereNoMaterialIsGiven() throws IOException {
        String text = "v 0 0 0 1\nv 0 0 1 .5 .25 0\nv 1 0 1 1 .1 .2 .3\nf 1 2 3\n";
        assertReflectances(read(text, ReadOptions.defaults()), .8, .8, .8, .5, .25, 0, .1, .2, .3);
        assertEquals(List.of(), told);
        assertEquals(Srgb.linear(.25), .9999 * read(text, ReadOptions.defaults().withSrgb(true)).vertexColours()[4], 1e-6);
    }

    @Test
    void coloursOfVertices_areFactorsOfTheMaterial_butNotOfItsImage() throws IOException {
        library("m.mtl", "newmtl a\nKd .5 1 .5\nnewmtl b\nKd .6 .6 .6\nmap_Kd wood.png\nnewmtl c\nmap_Kd lost.png\n");
        library("wood.png", "");
        Scene scene = read("mtllib m.mtl\nv 0 0 0 1 .5 .5\nv 0 0 1 .5 1 0\nv 1 0 1 0 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"
                + "usemtl b\nf 1 3 4\nusemtl c\nf 1 2 4\n", ReadOptions.defaults());
        assertReflectances(scene, .5, .5, .25, .25, .9999, 0, 0, 0, 0, .6, .6, .6, .6, .6, .6, .6, .6, .6,
                .9999, .5, .5, .5, .9999, 0, .8, .8, .8);
        assertEquals(List.of("reflectances of 1 and more are taken as 0.9999: a, c (2 times)"), told.stream()
                .filter(line -> line.contains("reflectances")).map(line -> line.substring("room.obj: ".length())).toList());
    }

    @Test
    void coloursOfVertices_mayBeWholeNumbers_andWhiteSaysNothing() throws IOException {
        assertReflectances(read("v 0 0 0 51 102 0\nv 0 0 1 1 0 0\nv 1 0 1 0 204 0\nf 1 2 3\n", ReadOptions.defaults()),
                .2, .4, 0, 1 / 255.0, 0, 0, 0, .8, 0);
        assertReflectances(read("v 0 0 0 255 255 255\nv 0 0 1 255 255 255\nv 1 0 1\nf 1 2 3\n",
                ReadOptions.defaults()), .8, .8, .8, .8, .8, .8, .8, .8, .8);
        told.clear();
        read("v 0 0 0 .5 .5\nv 0 0 1 -1 0 0\nv 1 0 1 red 0 0\nf 1 2 3\n", ReadOptions.defaults());
        assertEquals("room.obj, line 1: colours of vertices that are not three numbers of at least 0 are left out"
                + " (3 times)", told.get(0));
    }

    @Test
    void comments_mayFollowNumbers() throws IOException {
        Scene scene = read("v 0 0 0 # the origin\nv 0 0 1\t# one\nv 1 0 1 1 # weight\nf 1 2 3 # a triangle\n",
                ReadOptions.defaults());
        assertEquals(List.of(), told.stream().filter(line -> line.contains("line")).toList());
        assertEquals(1, scene.triangles());
    }

    @Test
    void smoothingGroupsAndNormals_giveTheSmoothingAngle() throws IOException {
        assertEquals(0, read(strip("f 1 2 3 4\n", "f 4 3 5 6\n", "f 6 5 7 8\n")).surface(0).smoothing());
        assertEquals(Math.toRadians(90), read(strip("s 1\nf 1 2 3 4\n", "f 4 3 5 6\n", "f 6 5 7 8\n")).surface(0)
                .smoothing(), .02);
        assertEquals(Math.toRadians(45), read(strip("s 1\nf 1 2 3 4\n", "s 2\nf 4 3 5 6\n", "f 6 5 7 8\n")).surface(0)
                .smoothing(), .02);
        assertEquals(0, read(strip("s off\nf 1 2 3 4\n", "f 4 3 5 6\n", "s 0\nf 6 5 7 8\n")).surface(0).smoothing());
        assertEquals(Math.toRadians(45), read(strip("s 1\nf 1//2 2//2 3//2 4//2\n", "f 4//1 3//1 5//1 6//1\n",
                "f 6//-2 5//-2 7//2 8//2\n")).surface(0).smoothing(), .02, "normals come before groups");
        assertEquals(0, read(strip("f 1//9 2//9 3//x 4//\n", "f 4//0 3//-7 5//1 6//1\n", "f 6 5 7 8\n")).surface(0)
                .smoothing(), "normals that do not exist");
    }

    /** As programs write them that give each polygon normals of its own, and of any length. */
    @Test
    void normalsThatDifferByRounding_areEqual() throws IOException {
        String strip = strip("f 1//1 2//1 3//2 4//2\n", "f 4//3 3//3 5//4 6//4\n", "").replace("vn 1 0 0\nvn 0 1 0\n",
                "vn 0 1 0\nvn 1 1 0\nvn 2.0001 2 0\nvn 1 0 0\n");
        assertEquals(Math.toRadians(90), read(strip).surface(0).smoothing(), .02);
    }

    private Scene read(String text) throws IOException {
        return read(text, ReadOptions.defaults());
    }

    private void library(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name), text);
    }

    @Test
    void materials_areReflectanceAndExitance_ofALibraryFoundWithoutCase() throws IOException {
        library("ROOM MATERIALS.MTL", "newmtl paint\nKd .1 .2 .3\nKs 1 1 1\nnewmtl glow\nKd 0\nKe 17 12 4\n");
        Scene scene = read(SQUARES);
        assertEquals(List.of(), told);
        assertEquals(List.of("paint", "glow"), scene.surfaces().stream().map(Surface::name).toList());
        assertEquals(new Rgb(.1, .2, .3), scene.surfaces().get(0).reflectance());
        assertEquals(Rgb.BLACK, scene.surfaces().get(1).reflectance());
        assertEquals(new Rgb(17, 12, 4), scene.surfaces().get(1).exitance());
        assertEquals(4, scene.triangles());
        assertEquals(5, scene.area(), 1e-12);
        assertEquals(new Vec3(0, 4, 0), scene.cross(0), "corners run counter-clockwise seen from the visible side");
        assertEquals(new Vec3(0, -1, 0), scene.cross(2).times(1));
    }

    @Test
    void twoSided_isWhatDoesNotEmit_whereTheOptionsSaySo() throws IOException {
        library("ROOM MATERIALS.MTL", "newmtl paint\nKd .1 .2 .3\nnewmtl glow\nKd 0\nKe 17 12 4\n");
        assertEquals(List.of(false, false), read(SQUARES).surfaces().stream().map(Surface::twoSided).toList());
        assertEquals(List.of(true, false), read(SQUARES, ReadOptions.defaults().withTwoSided(true)).surfaces().stream()
                .map(Surface::twoSided).toList());
    }

    @Test
    void missingLibrary_isOneLine_andSoAreItsMaterials() throws IOException {
        Scene scene = read(SQUARES);
        assertEquals(List.of("room.obj: material libraries that are not found leave a light grey: Room, Materials.mtl"
                + " (2 times)", "room.obj: materials that no library describes are taken as a light grey: paint, glow"
                + " (2 times)"), told);
        assertEquals(Rgb.grey(.8), scene.surfaces().get(0).reflectance());
        SceneFormatException strict = assertThrows(SceneFormatException.class,
                () -> read(SQUARES, ReadOptions.defaults().withStrict(true)));
        assertTrue(strict.getMessage().startsWith("room.obj: expected no warning (--strict), got "),
                strict.getMessage());
    }

    @Test
    void objectsAndGroups_areNodes() throws IOException {
        Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no house\nf 1 2 3\ng roof left\nf 1 2 3\ng door\n"
                + "f 1 2 3\no\ng tree\nf 1 2 3\no house\nf 1 2 3\n");
        assertEquals(List.of("room -1", "house -1", "roof left 1", "door 1", "tree -1"),
                scene.hierarchy().nodes().stream().map(node -> node.name() + " " + node.parent()).toList());
        assertEquals(5, scene.triangles(), "an equal polygon of the same object is dropped");
        assertEquals(List.of("room", "house", "roof left", "door", "tree"),
                scene.hierarchy().nodes().stream().map(SceneNode::geometry).toList());
        for (int t = 0; t < 5; t++) {
            assertEquals(t, scene.hierarchy().of(t));
        }
    }

    /** The letter L: three unit squares; a fan from its first corner would leave it. */
    @Test
    void polygonsOfAnyShape_keepTheirArea() throws IOException {
        Scene scene = read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 2/1/1 3 4 5 6 1\n");
        assertEquals(4, scene.triangles());
        double signed = 0;
        for (int t = 0; t < 4; t++) {
            signed += scene.cross(t).z() / 2;
        }
        assertEquals(3, signed, 1e-12);
        assertEquals(3, scene.area(), 1e-12);
    }

    @Test
    void images_varyReflectanceAndExitance_andLieAsTheirOptionsSay() throws IOException {
        library("m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd -s 2 3 1 -o .5 0 -clamp on my wood.png\nmap_Ke -s 2 3 -o .5 "
                + "-clamp on glow.png\n");
        library("my wood.png", "");
        library("GLOW.PNG", "");
        Scene scene = read("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\n"
                + "f 1/1 2/2 3/-1\n");
        assertEquals(List.of(), told);
        List<ImageMap> maps = scene.surfaces().get(0).textures();
        assertEquals(List.of(ImageMap.Target.REFLECTANCE, ImageMap.Target.EXITANCE),
                maps.stream().map(ImageMap::target).toList());
        assertTrue(maps.get(0).image().name().endsWith("my wood.png"));
        assertEquals(Rgb.grey(1), maps.get(0).scale());
        assertEquals(Rgb.grey(1), maps.get(1).scale());
        assertEquals(ImageMap.Wrap.EDGE, maps.get(0).wrapU());
        assertEquals(List.of(.5f, 0f, 2.5f, 0f, .5f, 3f), List.of(scene.textureCoordinates()[0],
                scene.textureCoordinates()[1], scene.textureCoordinates()[2], scene.textureCoordinates()[3],
                scene.textureCoordinates()[4], scene.textureCoordinates()[5]));
    }

    @Test
    void triangleWithACoordinateThatIsNoFiniteNumber_hasNoImage() throws IOException {
        library("m.mtl", "newmtl a\nmap_Kd -s 1e30 1 wood.png\n");
        library("wood.png", "");
        Scene scene = read("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1e30 1\nusemtl a\n"
                + "f 1/1 2/2 4/2\nf 1/1 4/2 3/3\n");
        assertTrue(Float.isFinite(scene.textureCoordinates()[5]));
        for (int i = 6; i < 12; i++) {
            assertTrue(Float.isNaN(scene.textureCoordinates()[i]));
        }
    }

    @Test
    void imageOfTheLight_liesAsItIs_whereTheOneOfTheReflectanceIsMissing() throws IOException {
        library("m.mtl", "newmtl a\nKd .5\nmap_Kd -s 2 3 wood.png\nmap_Ke -s 5 7 glow.png\n");
        library("glow.png", "");
        Scene scene = read("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\n"
                + "f 1/1 2/2 3/3\n");
        assertEquals(List.of("room.obj: images that are not found leave the base colour, a light grey where it is white:"
                + " wood.png"), told);
        assertEquals(List.of(ImageMap.Target.EXITANCE),
                scene.surfaces().get(0).textures().stream().map(ImageMap::target).toList());
        assertArrayEquals(new float[] {0, 0, 5, 0, 0, 7}, scene.textureCoordinates());
    }

    @Test
    void whiteUnderAnImageThatIsMissing_isALightGrey() throws IOException {
        library("m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd wood.png\nnewmtl b\nKd 1 1 .5\nmap_Kd wood.png\n"
                + "newmtl c\nmap_Kd wood.png\n");
        List<Surface> surfaces = read("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl a\nf 1 2 3\nusemtl b\n"
                + "f 1 2 4\nusemtl c\nf 1 3 4\n").surfaces();
        assertEquals(Rgb.grey(.8), surfaces.get(0).reflectance());
        assertEquals(new Rgb(1, 1, .5).atMost(Surface.MAX_REFLECTANCE), surfaces.get(1).reflectance());
        assertEquals(Rgb.grey(.8), surfaces.get(2).reflectance());
    }

    @Test
    void librariesInQuotes_areFound() throws IOException {
        library("Room Scan 1.mtl", "newmtl a\nKd .1 .1 .1\n");
        library("b.mtl", "newmtl b\nKd .2 .2 .2\n");
        Scene scene = read("mtllib \"Room Scan 1.mtl\"\nmtllib \"lost one.mtl\" b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 4\n");
        assertEquals(Rgb.grey(.1), scene.surfaces().get(0).reflectance());
        assertEquals(Rgb.grey(.2), scene.surfaces().get(1).reflectance());
        assertEquals(List.of("room.obj: material libraries that are not found leave a light grey: lost one.mtl"), told);
    }

    @Test
    void backslashAtTheEndOfAComment_isAPath() throws IOException {
        Scene scene = read("# from C:\\House\\\nv 0 0 0\nv 0 0 1\nv 1 0 \\\n1\nf 1 2 3\n", ReadOptions.defaults());
        assertEquals(1, scene.triangles());
        assertEquals(new Vec3(1, 0, 1), scene.corner(0, 2));
    }

    @Test
    void transparencyOfALibrary_isD_orElseTr() throws IOException {
        library("m.mtl", "newmtl glass\nKd .1 .1 .1\nd -halo 0.5\nnewmtl tint\nTr .4\n"
                + "newmtl opaque\nd 1\nTr 1\nkd .3 .3 .3\nmap_Kd \"D:\\maps\\my wood.png\"\n");
        Scene scene = read("mtllib m.mtl\nv 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nv 0 1 0\nusemtl glass\nf 1 2 3\n"
                + "usemtl tint\nf 1 3 4\nusemtl opaque\nf 1 2 5\n", ReadOptions.defaults());
        assertEquals(List.of("room.obj: images that are not found leave the base colour, a light grey where it is white:"
                + " D:\\maps\\my wood.png",
                "room.obj: transparent surfaces are taken as opaque (see --leave-out): glass, tint (2 times)"),
                told.stream().filter(line -> line.contains("images") || line.contains("transparent")).sorted().toList());
        assertEquals(Rgb.grey(.3), scene.surfaces().get(2).reflectance());
    }

    @Test
    void zThatPointsUp_becomesY() throws IOException {
        String floor = "v 0 0 0\nv 2 0 0\nv 0 1 .5\nvn 0 0 1\nf 1//1 2//1 3//1\n";
        Scene scene = read(floor, ReadOptions.defaults().withUp(ReadOptions.Up.Z));
        assertEquals(new Vec3(0, .5, -1), scene.corner(0, 2));
        assertTrue(scene.cross(0).y() > 0, "the floor faces " + scene.cross(0));
        assertEquals(new Vec3(0, 1, .5), read(floor, ReadOptions.defaults()).corner(0, 2));
    }

    /** A point that no polygon has, as exporters write for the origin of a survey. */
    @Test
    void unusedVertex_leavesASceneFarAway() throws IOException {
        Scene scene = read("v 0 0 0\nv 500000.125 5600000.001 0\n"
                + "v 500001.125 5600000.001 0\nv 500000.125 5600001.003 0\nf 2 3 4\n");
        assertEquals(5600000.001, scene.corner(0, 0).y(), 1e-6);
    }

    /** Coordinates of a land survey: floats alone would be off by 3 cm. */
    @Test
    void sceneFarFromTheOrigin_keepsItsDigits() throws IOException {
        Scene scene = read("v 500000.125 5600000.001 0\n"
                + "v 500001.125 5600000.001 0\nv 500000.125 5600001.003 0\nf 1 2 3\n");
        assertEquals(500000.125, scene.corner(0, 0).x(), 1e-6);
        assertEquals(5600000.001, scene.corner(0, 0).y(), 1e-6);
        assertEquals(1.002 / 2, scene.area(), 1e-6);
    }

    @Test
    void whatIsWrong_isNamedWithItsLine() throws IOException {
        read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv x 0 0\nf 1 2 3\nf 1 2 9\nf 1 2 99999999999\nf 1 2 4\nf 1 1 2\ncurv 0 1\n");
        assertEquals(List.of(
                "room.obj, line 10: curves and free-form surfaces are left out: curv",
                "room.obj, line 6: polygons with points that do not exist are dropped (2 times)",
                "room.obj, line 8: polygons with coordinates that are no finite numbers are dropped",
                "room.obj, line 9: polygons without area are dropped"),
                told.stream().filter(line -> line.contains(", line")).toList());
        SceneFormatException empty = assertThrows(SceneFormatException.class, () -> read("v 0 0 0\n"));
        assertEquals("room.obj: expected at least one polygon with an area, got none", empty.getMessage());
    }

    @Test
    void colours_areMadeLinear_whereTheUserSaysSo_butNotLight() throws IOException {
        library("m.mtl", "newmtl a\nKd .5 .5 .5\nKe 2 2 2\n");
        Scene scene = read("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n",
                ReadOptions.defaults().withSrgb(true));
        assertEquals(.214041, scene.surfaces().get(0).reflectance().g(), 1e-6);
        assertEquals(2, scene.surfaces().get(0).exitance().g());
    }

    @Test
    void text_isUtf8OrLatin1_withAnyEndsOfLines() throws IOException {
        Path file = folder.resolve("room.obj");
        Files.write(file, "o caf\u00e9\r\nv 0 0 0\rv 1 0 0\nv 0 1 0\nf 1 2 3".getBytes(StandardCharsets.ISO_8859_1));
        assertEquals("caf\u00e9", ObjReader.read(file, ReadOptions.defaults(), told::add).hierarchy().nodes().get(0)
                .name());
    }
}
