package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.scene.Vec3;
import radiosity.testkit.ProgramRun;

/**
 * A photometric file through the whole program, from glTF (metres) and OBJ (centimetres) to tables of illuminance.
 *
 * <p>The room, 4 m x 3 m x 4 m, is black, so that all light comes from the luminaire at L = (2, 2.5, 2), which shines
 * down with I(C, g) = 2.7 x 800 cd (1 + cos C / 2 + sin C / 4) cos g, where 2.7 is multiplier times ballast factor. C0
 * is along x and C90 = C0 x down along -z. At p, with d = p - L and the normal n: E = I / d² (-d . n) / |d|. The file
 * has I at each degree of g and every fifth of C, and is linear between these, as is what is expected in C; in g the
 * chord is at most (1 degree)² / 8 = 4e-5 of I below its arc.
 */
@Tag("slow")
class LuminaireRenderTest {

    private static final Vec3 LAMP = new Vec3(2, 2.5, 2);
    private static final Vec3 UP = new Vec3(0, 1, 0);
    /** Corner i of the room has x from bit 0, y from bit 1, z from bit 2 of i. */
    private static final int[][] FACES = {{0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 2, 6, 4},
        {1, 5, 7, 3}};

    @TempDir
    Path folder;

    private static double intensity(double c, double g) {
        return 800 * (1 + Math.cos(c) / 2 + Math.sin(c) / 4) * Math.max(0, Math.cos(g));
    }

    private static double illuminance(Vec3 p, Vec3 n) {
        Vec3 d = p.minus(LAMP);
        double step = Math.toRadians(5);
        double c = Math.atan2(-d.z(), d.x()) / step;
        double g = Math.acos(-d.y() / d.length());
        double before = Math.floor(c);
        double linear = (1 - c + before) * intensity(step * before, g)
                + (c - before) * intensity(step * (before + 1), g);
        return 2.7 * linear * -d.dot(n) / Math.pow(d.length(), 3);
    }

    private String lamp() {
        StringBuilder file = new StringBuilder("IESNA:LM-63-2002\n[TEST] made here\nTILT=NONE\n"
                + "1 1000 3 91 73 1 2 0 0 0\n0.9 1 30\n");
        for (int g = 0; g <= 90; g++) {
            file.append(g).append('\n');
        }
        for (int c = 0; c <= 360; c += 5) {
            file.append(c).append('\n');
        }
        for (int c = 0; c <= 360; c += 5) {
            for (int g = 0; g <= 90; g++) {
                file.append(String.format(Locale.ROOT, "%.6f%n", intensity(Math.toRadians(c), Math.toRadians(g))));
            }
        }
        return file.toString();
    }

    private static double[] corner(int i) {
        return new double[] {4 * (i & 1), 3 * (i >> 1 & 1), 4 * (i >> 2)};
    }

    private static String base64(byte[] bytes) {
        return "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(bytes);
    }

    /**
     * The room as glTF; its second node, three times as large and turned so that -z is down, has the extension.
     *
     * @param ies the luminaire's file among the extension's lights
     */
    private void gltf(String node, String top, byte[] ies) throws IOException {
        ByteBuffer room = ByteBuffer.allocate(8 * 12 + 36 * 2).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < 8; i++) {
            Arrays.stream(corner(i)).forEach(x -> room.putFloat((float) x));
        }
        for (int[] f : FACES) {
            for (int k : new int[] {0, 1, 2, 0, 2, 3}) {
                room.putShort((short) f[k]);
            }
        }
        Files.writeString(folder.resolve("room.gltf"), """
                {"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
                "extensionsUsed":["KHR_lights_punctual","EXT_lights_ies"],
                "nodes":[{"name":"Room","mesh":0},{"name":"Lamp","translation":[2,2.5,2],"scale":[3,3,3],
                "rotation":[-0.70710678,0,0,0.70710678],"extensions":{%s}}],
                "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
                "materials":[{"name":"black","pbrMetallicRoughness":{"baseColorFactor":[0,0,0,1],"metallicFactor":0}}],
                "accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],"max":[4,3,4]},
                {"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],
                "bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72},
                {"buffer":1,"byteLength":%d}],
                "buffers":[{"byteLength":168,"uri":"%s"},{"byteLength":%d,"uri":"%s"}],
                "extensions":{%s}}
                """.formatted(node, ies.length, base64(room.array()), ies.length, base64(ies), top));
    }

    private void obj() throws IOException {
        StringBuilder file = new StringBuilder("mtllib room.mtl\nusemtl black\n");
        for (int i = 0; i < 8; i++) {
            double[] x = corner(i);
            file.append("v " + 100 * x[0] + " " + 100 * x[1] + " " + 100 * x[2] + "\n");
        }
        for (int[] f : FACES) {
            file.append("f");
            Arrays.stream(f).forEach(i -> file.append(' ').append(i + 1));
            file.append('\n');
        }
        Files.writeString(folder.resolve("room.obj"), file);
        Files.writeString(folder.resolve("room.mtl"), "newmtl black\nKd 0 0 0\n");
    }

    private static List<double[]> table(Path file) throws IOException {
        return Files.readAllLines(file).stream().filter(line -> !line.isEmpty() && !Character.isLetter(line.charAt(0))
                && line.charAt(0) != '#').map(line -> Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble)
                .toArray()).toList();
    }

    @ParameterizedTest
    @CsvSource({"extension, beside, 1", "extension, inside, 1", "extension, half, 1", "name, beside, 1",
        "place, beside, 100"})
    void illuminance_isThatOfTheFile(String way, String where, double unit) throws IOException {
        byte[] ies = lamp().getBytes(StandardCharsets.US_ASCII);
        Path file = Files.write(folder.resolve("lamp.ies"), ies);
        double factor = where.equals("half") ? .5 : 1;
        switch (way) {
            case "extension" -> gltf("\"EXT_lights_ies\":{\"light\":0,\"multiplier\":" + factor + "}",
                    "\"EXT_lights_ies\":{\"lights\":[{" + (where.equals("inside")
                    ? "\"bufferView\":2,\"mimeType\":\"application/x-ies-lm-63\"" : "\"uri\":\"lamp.ies\"") + "}]}",
                    ies);
            case "name" -> gltf("\"KHR_lights_punctual\":{\"light\":0}", "\"KHR_lights_punctual\":{\"lights\":"
                    + "[{\"type\":\"spot\",\"name\":\"Lamp\",\"intensity\":7,\"spot\":{}}]}", ies);
            default -> obj();
        }
        List<Vec3> points = new ArrayList<>();
        List<Vec3> normals = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            points.add(new Vec3(.3 + .3 * i, 0, .2 + .31 * (i * 5 % 12)));
            normals.add(UP);
            points.add(new Vec3(4, .2 + .15 * i, .3 + .3 * (i * 7 % 12)));
            normals.add(new Vec3(-1, 0, 0));
        }
        StringBuilder asked = new StringBuilder();
        for (int i = 0; i < points.size(); i++) {
            Vec3 p = points.get(i).times(unit);
            Vec3 n = normals.get(i);
            asked.append(p.x() + "," + p.y() + "," + p.z() + "," + n.x() + "," + n.y() + "," + n.z() + "\n");
        }
        Files.writeString(folder.resolve("in.csv"), asked);
        List<String> words = new ArrayList<>(List.of("-q", "--accuracy", "1%", "--points", folder + "/in.csv",
                folder + "/points.csv", "--grid", "y=" + .5 * unit, folder + "/grid.csv", "--spacing", "" + .5 * unit));
        words.addAll(switch (way) {
            case "extension" -> List.of();
            case "name" -> List.of("--luminaire", "Lamp=" + file);
            default -> List.of("--unit", "cm", "--photometric", "--luminaire", "200,250,200=" + file);
        });
        words.addAll(List.of(folder + (way.equals("place") ? "/room.obj" : "/room.gltf"), folder + "/room.scene"));
        ProgramRun run = ProgramRun.of(words.toArray());
        assertEquals(0, run.exitCode(), run.err());
        assertEquals("", run.err());
        List<double[]> found = table(folder.resolve("points.csv"));
        assertEquals(points.size(), found.size());
        double largest = factor * illuminance(new Vec3(2, 0, 2), UP);
        for (int i = 0; i < points.size(); i++) {
            double e = factor * illuminance(points.get(i), normals.get(i));
            assertEquals(e, found.get(i)[12], .002 * largest, points.get(i).toString());
        }
        List<double[]> grid = table(folder.resolve("grid.csv"));
        assertEquals(64, grid.size());
        for (double[] row : grid) {
            double e = factor * illuminance(new Vec3(row[0], row[1], row[2]).times(1 / unit), UP);
            assertEquals(e, row[6], 1e-4 * e, Arrays.toString(row));
        }
        Matcher flux = Pattern.compile("emitted ([\\d.]+) lm = ").matcher(run.out());
        assertTrue(flux.find(), run.out());
        double all = factor * 2.7 * 800 * Math.PI;
        assertEquals(all, Double.parseDouble(flux.group(1)), 1e-5 * all, "cosine and sine of C cancel");
    }
}
