package radiosity.input;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.Radiosity;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;

/** One room in several formats; and a room that Blender wrote (make_room.py beside the files). */
class SameRoomTest {

    @TempDir
    Path folder;
    private final List<String> told = new ArrayList<>();

    private Scene read(Path file) throws IOException {
        return Radiosity.read(file, told::add);
    }

    private static Path made(String name) throws URISyntaxException {
        return Path.of(SameRoomTest.class.getResource(name).toURI());
    }

    /** The Cornell box that comes with the program, written from its triangles as OBJ and as glTF. */
    @Test
    void lightWave_gltf_andObj_giveTheSameTrianglesAndRadiosities() throws IOException {
        Scene lightWave = read(Path.of("scenes/cornell-box.lws"));
        Scene obj = read(Files.writeString(folder.resolve("box.obj"), obj(lightWave)));
        Scene gltf = read(Files.writeString(folder.resolve("box.gltf"), gltf(lightWave)));
        Solution expected = solved(lightWave);
        for (Scene other : List.of(obj, gltf)) {
            assertEquals(triangles(lightWave), triangles(other));
            Solution got = solved(other);
            assertArrayEquals(expected.positions(), got.positions(), 1e-9);
            for (int e = 0; e < expected.elements(); e++) {
                for (int k = 0; k < 3; k++) {
                    Rgb wanted = expected.radiosityAt(e, k);
                    for (int c = 0; c < 3; c++) {
                        assertEquals(wanted.channel(c), got.radiosityAt(e, k).channel(c),
                                1e-5 * Math.max(1e-3, wanted.channel(c)));
                    }
                }
            }
        }
        assertEquals(List.of(), told);
    }

    private static Solution solved(Scene scene) throws IOException {
        return Radiosity.of(scene).settings(new RadiositySettings(20_000, 2, Double.POSITIVE_INFINITY, Schedule.PAPER))
                .stop(new StopRule(100, 0)).threads(1).run(progress -> true).solution();
    }

    private static List<String> triangles(Scene scene) {
        List<String> triangles = new ArrayList<>();
        for (int t = 0; t < scene.triangles(); t++) {
            Surface s = scene.surface(t);
            triangles.add(scene.corner(t, 0) + " " + scene.corner(t, 1) + " " + scene.corner(t, 2) + " " + s.name()
                    + " " + s.reflectance() + " " + s.exitance());
        }
        return triangles;
    }

    private String obj(Scene scene) throws IOException {
        StringBuilder materials = new StringBuilder();
        for (Surface s : scene.surfaces()) {
            materials.append(String.format(Locale.ROOT, "newmtl %s%nKd %s %s %s%nKe %s %s %s%n", s.name(),
                    s.reflectance().r(), s.reflectance().g(), s.reflectance().b(), s.exitance().r(), s.exitance().g(),
                    s.exitance().b()));
        }
        Files.writeString(folder.resolve("box.mtl"), materials);
        StringBuilder text = new StringBuilder("mtllib box.mtl\n");
        for (int p = 0; p < scene.points().length; p += 3) {
            text.append("v ").append(scene.points()[p]).append(' ').append(scene.points()[p + 1]).append(' ')
                    .append(scene.points()[p + 2]).append('\n');
        }
        for (int t = 0; t < scene.triangles(); t++) {
            text.append("usemtl ").append(scene.surface(t).name()).append("\nf");
            for (int k = 0; k < 3; k++) {
                text.append(' ').append(1 + scene.corners()[3 * t + k]);
            }
            text.append('\n');
        }
        return text.toString();
    }

    /** A primitive for each triangle. */
    private static String gltf(Scene scene) {
        ByteBuffer bytes = ByteBuffer.allocate(36 * scene.triangles())
                .order(ByteOrder.LITTLE_ENDIAN);
        List<String> accessors = new ArrayList<>();
        List<String> primitives = new ArrayList<>();
        for (int t = 0; t < scene.triangles(); t++) {
            accessors.add("{\"bufferView\":0,\"byteOffset\":" + bytes.position()
                    + ",\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}");
            primitives.add("{\"attributes\":{\"POSITION\":" + t + "},\"material\":" + scene.surfaceOf()[t] + "}");
            for (int k = 0; k < 3; k++) {
                Vec3 p = scene.corner(t, k);
                bytes.putFloat((float) p.x()).putFloat((float) p.y()).putFloat((float) p.z());
            }
        }
        List<String> materials = scene.surfaces().stream().map(s -> "{\"name\":\"" + s.name()
                + "\",\"emissiveFactor\":" + list(s.exitance().times(1.0 / 1024)) + ",\"extensions\":{"
                + "\"KHR_materials_emissive_strength\":{\"emissiveStrength\":1024}},\"pbrMetallicRoughness\":{"
                + "\"baseColorFactor\":" + list(s.reflectance()).replace("]", ",1]") + "}}").toList();
        return "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":["
                + "{\"primitives\":" + primitives + "}],\"materials\":" + materials + ",\"accessors\":" + accessors
                + ",\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + bytes.capacity() + "}],\"buffers\":["
                + "{\"byteLength\":" + bytes.capacity() + ",\"uri\":\"data:;base64,"
                + Base64.getEncoder().encodeToString(bytes.array()) + "\"}]}";
    }

    private static String list(Rgb rgb) {
        return "[" + rgb.r() + "," + rgb.g() + "," + rgb.b() + "]";
    }

    private static Map<String, Double> areas(Scene scene) {
        Map<String, Double> areas = new TreeMap<>();
        for (int t = 0; t < scene.triangles(); t++) {
            areas.merge(scene.surface(t).name(), scene.area(t), Double::sum);
        }
        return areas;
    }

    /** Walls of 4 x 3 x 2.5, two stools of .5 x .5 x .6 and .8 with their undersides, a panel of 1 x 1. */
    @ParameterizedTest
    @CsvSource({"room.glb", "room.obj"})
    void blendersRoom_hasItsAreasAndColours(String name) throws IOException, URISyntaxException {
        Scene scene = read(made(name));
        assertEquals(List.of(), told);
        Map<String, Double> areas = areas(scene);
        assertEquals(2 * (4 * 3 + 4 * 2.5 + 3 * 2.5) - 3 * 2.5, areas.get("white"), 1e-5);
        assertEquals(3 * 2.5, areas.get("red"), 1e-5);
        assertEquals(4 * .25 + 4 * .5 * (.6 + .8), areas.get("wood"), 1e-5);
        assertEquals(1, areas.get("lamp"), 1e-6);
        for (Surface s : scene.surfaces()) {
            Rgb expected = switch (s.name()) {
                case "white" -> new Rgb(.7, .7, .7);
                case "red" -> new Rgb(.6, .1, .05);
                case "wood" -> new Rgb(.4, .25, .1);
                default -> Rgb.BLACK;
            };
            double perEmission = name.endsWith(".glb") ? Math.PI : 1; // with a lamp in candela, it is in cd/m2
            Rgb light = s.name().equals("lamp") ? new Rgb(12, 9.6, 6).times(perEmission) : Rgb.BLACK;
            for (int c = 0; c < 3; c++) {
                assertEquals(expected.channel(c), s.reflectance().channel(c), 1e-6, s.name());
                assertEquals(light.channel(c), s.exitance().channel(c), 1e-5, s.name());
            }
        }
    }

    @Test
    void blendersObjects_hierarchyInstancesLightAndCamera_areTheScenes() throws IOException, URISyntaxException {
        Scene scene = read(made("room.glb"));
        List<SceneNode> nodes = scene.hierarchy().nodes();
        Map<String, String> parents = new TreeMap<>();
        for (SceneNode node : nodes) {
            parents.put(node.name(), (node.parent() < 0 ? "" : nodes.get(node.parent()).name()) + "|"
                    + node.geometry());
        }
        assertEquals(Map.of("Room", "|RoomShell", "Furniture", "Room|", "Stool near", "Furniture|Stool", "Stool far",
                "Furniture|Stool", "Lamp", "Room|Panel", "Bulb", "Room|", "View", "|"), parents);
        Light bulb = scene.lights().get(0);
        assertEquals(Light.Kind.POINT, bulb.kind());
        assertEquals(50 * 683 / (4 * Math.PI), bulb.power().r(), 1e-2, "Blender's watts are candela in the file");
        assertEquals(0, bulb.position().minus(new Vec3(3, 1.5, -2)).length(), 1e-6, "Blender's z is up");
        assertEquals(0, scene.camera().orElseThrow().position().minus(new Vec3(2, 1.3, -.2)).length(), 1e-6);
        assertEquals(0, scene.camera().orElseThrow().forward().minus(new Vec3(0, 0, -1)).length(), 1e-6);
    }

    /** By content where it says it, else by name. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "a.fbx|Kaydara FBX Binary  |an FBX file", "a.obj|Kaydara FBX Binary  |an FBX file", "b.blend|BLENDER-v300|a "
                + "Blender file", "c.dae|<?xml?><COLLADA xmlns=''>|a Collada file (DAE)",
        "d.stl|solid cube facet normal|an STL file", "e.stl|123|an STL file", "f.ply|ply~123|a PLY file",
        "g.usda|#usda 1.0|a USD file", "h.usdz|PK\3\4|a USD file", "i.3ds|123|a 3DS file",
        "j.png|\u0089PNG|a PNG image",
        "k.xml|<scene version='3'>|a scene in XML, as of Mitsuba", "l.mtl|newmtl a|a material library of OBJ files",
        "m.txt|hello there|a file that begins with \"hello there\"", "n.json|{}|a file that begins with \"{}\""})
    void filesOfOtherKinds_areNamed(String name, String content, String kind) throws IOException {
        Path file = Files.write(folder.resolve(name), content.replace('~', '\n').getBytes(StandardCharsets.ISO_8859_1));
        assertEquals(name + ": expected a scene, got " + kind + "; LightWave, glTF and OBJ are read",
                assertThrows(SceneFormatException.class, () -> read(file)).getMessage());
    }

    /** Editors of Windows write UTF-16 with a byte order mark, or without one. */
    @ParameterizedTest
    @CsvSource({"UTF-16LE, \ufeff", "UTF-16BE, \ufeff", "UTF-16LE, ''", "UTF-16BE, ''"})
    void textInUtf16_isNamed_andWhatItMustBe(String charset, String mark) throws IOException {
        Map<String, String> contents = Map.of("a.obj", "# a triangle\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                "a.lws", "LWSC\n1\n", "a.gltf", "{\"asset\": {\"version\": \"2.0\"}}", "a.mtl", "newmtl a\n",
                "nothing", "v 0 0 0\n");
        for (Map.Entry<String, String> content : contents.entrySet()) {
            Path file = Files.writeString(folder.resolve(content.getKey()), mark + content.getValue(),
                    Charset.forName(charset));
            assertEquals(content.getKey() + ": expected a scene, got text in UTF-16; LightWave scenes, glTF and OBJ are"
                    + " in UTF-8 or ASCII", assertThrows(SceneFormatException.class, () -> read(file)).getMessage());
        }
        Files.writeString(folder.resolve("a.mtl"), mark + "newmtl a\nKd 1 0 0\n", Charset.forName(charset));
        Path room = Files.writeString(folder.resolve("b.obj"), "mtllib a.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                + "f 1 2 3\n");
        assertEquals("a.mtl: expected a material library in UTF-8 or ASCII, got text in UTF-16",
                assertThrows(SceneFormatException.class, () -> read(room)).getMessage());
    }

    @Test
    void contentDecides_andNotTheName() throws IOException {
        String triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        assertEquals(1, read(Files.writeString(folder.resolve("a.glb"), "# a\n\no x\n" + triangle)).triangles());
        assertEquals(1, read(Files.writeString(folder.resolve("nothing"), triangle)).triangles());
        SceneReader.read(folder.resolve("a.glb"), ReadOptions.defaults().withFrame(3), told::add);
        assertTrue(told.contains("a.glb: a frame is chosen for LightWave only"));
    }
}
