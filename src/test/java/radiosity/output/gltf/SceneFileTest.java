package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.gltf.CameraPose;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.Mesh;
import radiosity.output.mesh.TJunctions;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Specular;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.util.Aabb;

/** A solution comes back from a scene file as it was written. */
class SceneFileTest extends WrittenScene {

    private static Camera camera() {
        Vec3 forward = new Vec3(1, -2, -3).unit();
        Vec3 right = forward.cross(new Vec3(0, 1, 0)).unit();
        return new Camera(new Vec3(1, 2, 3), forward, right.cross(forward), .4, 1.5);
    }

    @Override
    public void write(Solution solution) throws IOException {
        SceneFile.write(file, solution, Map.of("commandLine", "RadiosityRenderer -pa 2 x.lws x.scene"),
                Optional.of(camera()), TONES);
    }

    @Test
    void meshes_comeBackAsTheyWere() throws IOException {
        Solution solution = Handmade.litRoom(Vec3.ZERO).solution();
        write(solution);
        try (SceneFile scene = SceneFile.open(file)) {
            List<Mesh> meshes = scene.meshes();
            assertEquals(solution.scene().surfaces(), meshes.stream().map(Mesh::surface).toList());
            assertEquals(TJunctions.close(solution).elements(), meshes.stream().mapToInt(Mesh::elements).sum());
            for (Mesh mesh : meshes) {
                assertLight(mesh, Vec3.ZERO);
            }
        }
    }

    private static void assertLight(Mesh mesh, Vec3 origin) {
        for (int i = 0; i < mesh.vertices(); i++) {
            float[] x = mesh.positions();
            Rgb h = Handmade.light(new Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]).plus(origin));
            for (int c = 0; c < 3; c++) {
                double b = mesh.surface().exitance().channel(c) + mesh.surface().reflectance()
                        .channel(c) * h.channel(c);
                assertEquals(h.channel(c), mesh.irradiance()[3 * i + c], 1e-6 * h.channel(c));
                assertEquals(b, mesh.radiosity()[3 * i + c], 1e-6 * b);
            }
        }
    }

    @Test
    void normals_andTheOrderOfCorners_agree() throws IOException {
        write(Handmade.litRoom(Vec3.ZERO).solution());
        try (SceneFile scene = SceneFile.open(file)) {
            Solution read = scene.solution();
            for (Mesh mesh : scene.meshes()) {
                float[] n = mesh.normals();
                for (int i = 0; i < mesh.corners().length; i++) {
                    Vec3 normal = new Vec3(n[3 * mesh.corners()[i]], n[3 * mesh.corners()[i] + 1],
                            n[3 * mesh.corners()[i] + 2]);
                    assertEquals(1, normal.length(), 1e-6);
                }
            }
            for (int e = 0; e < read.elements(); e++) {
                Vec3 inward = new Vec3(1, 1, 1).minus(Elements.corner(read, e, 0));
                assertTrue(read.surface(e).emits() || Elements.cross(read, e).dot(inward) > 0);
            }
        }
    }

    @Test
    void twoSidedSurface_isTwoMeshes_andOneSurfaceAgain() throws IOException {
        Handmade made = new Handmade();
        int t = made.triangle(made.surface("sheet", Rgb.BLACK, Rgb.grey(.5), true), Vec3.ZERO, new Vec3(1, 0, 0),
                new Vec3(0, 1, 0));
        Vec3[] corners = {Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0)};
        int[] front = Arrays.stream(corners).mapToInt(p -> made.vertex(p, Rgb.grey(4))).toArray();
        int[] back = Arrays.stream(corners).mapToInt(p -> made.vertex(p, Rgb.grey(9))).toArray();
        made.element(2 * t, front[0], front[1], front[2]);
        made.element(2 * t + 1, back[0], back[2], back[1]);
        write(made.solution());
        try (SceneFile scene = SceneFile.open(file)) {
            List<Mesh> meshes = scene.meshes();
            assertEquals(List.of(false, true), meshes.stream().map(Mesh::back).toList());
            assertEquals(1, meshes.get(0).normals()[2]);
            assertEquals(-1, meshes.get(1).normals()[2]);
            assertEquals(2, meshes.get(0).radiosity()[0]);
            assertEquals(4.5f, meshes.get(1).radiosity()[0]);
            Solution read = scene.solution();
            assertEquals(1, read.scene().surfaces().size());
            assertEquals(new Vec3(0, 0, -1), Elements.normal(read, 1));
            assertEquals(-1, Elements.cross(read, 1).z());
        }
    }

    @Test
    void extrasLedgerAndCamera_comeBack() throws IOException {
        write(Handmade.litRoom(Vec3.ZERO).solution());
        try (SceneFile scene = SceneFile.open(file)) {
            Map<String, Object> extras = scene.extras();
            assertEquals("RadiosityRenderer -pa 2 x.lws x.scene", extras.get("commandLine"));
            assertEquals(SceneFile.FORMAT_VERSION, extras.get("formatVersion"));
            assertTrue(extras.get("program").toString().startsWith("radiosity "));
            assertEquals(7, extras.get("shots"));
            assertEquals(5, extras.get("rounds"));
            assertEquals(.25, extras.get("unshotFlux"));
            assertArrayEquals(Handmade.LEDGER.unshot(), scene.ledger().unshot());
            assertArrayEquals(Handmade.LEDGER.absorbed(), scene.ledger().absorbed());
            Camera read = scene.camera().orElseThrow();
            assertEquals(camera().position(), read.position());
            assertEquals(0, camera().forward().minus(read.forward()).length(), 1e-15);
            assertEquals(0, camera().up().minus(read.up()).length(), 1e-15);
            assertEquals(camera().verticalHalfAngle(), read.verticalHalfAngle());
            assertEquals(camera().aspect(), read.aspect());
        }
    }

    @Test
    void everyRotation_ofACamera_comesBack() {
        Random random = new Random(2);
        for (int i = 0; i < 1000; i++) {
            Vec3 forward = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            Vec3 any = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            Camera camera = new Camera(Vec3.ZERO, forward, forward.cross(any).unit(), .3, 1);
            Camera read = CameraPose.camera(Vec3.ZERO, CameraPose.quaternion(camera), .6, 1);
            assertEquals(0, camera.forward().minus(read.forward()).length(), 1e-12);
            assertEquals(0, camera.up().minus(read.up()).length(), 1e-12);
        }
    }

    @Test
    void farFromTheOrigin_nothingIsLost() throws IOException {
        Vec3 far = new Vec3(1e7, -3e6, 12345.678);
        Handmade made = Handmade.room(far, 2, p -> Handmade.light(p.minus(far)));
        write(made.solution(camera()));
        try (SceneFile scene = SceneFile.open(file)) {
            assertTrue(scene.origin().length() > 1e7);
            Solution read = scene.solution();
            Aabb box = Aabb.of(read.positions());
            assertEquals(0, box.low().minus(far).length(), 1e-6);
            assertEquals(0, box.high().minus(far).minus(new Vec3(2, 2, 2)).length(), 1e-6);
            assertEquals(0, camera().position().minus(scene.camera().orElseThrow().position()).length(), 1e-8);
        }
    }

    @Test
    void nearTheOrigin_positionsAreThoseOfTheScene() throws IOException {
        write(Handmade.litRoom(new Vec3(3, 4, -5)).solution());
        try (SceneFile scene = SceneFile.open(file)) {
            assertEquals(Vec3.ZERO, scene.origin());
            assertEquals(new Vec3(3, 4, -5), Aabb.of(scene.solution().positions()).low());
        }
    }

    @Tag("slow")
    @Test
    void state_comesBackBitForBit() throws IOException {
        Handmade made = Handmade.litRoom(Vec3.ZERO);
        made.state = new byte[120_000_001];
        new Random(1).nextBytes(made.state);
        write(made.solution());
        try (SceneFile scene = SceneFile.open(file)) {
            assertEquals(SavedState.of(List.of(made.state)), scene.state());
        }
    }

    @Test
    void solutionWithoutState_hasNone() throws IOException {
        write(Handmade.litRoom(Vec3.ZERO).solution());
        try (SceneFile scene = SceneFile.open(file)) {
            assertEquals(SavedState.NONE, scene.state());
        }
    }

    @Test
    void sameSolution_givesTheSameFile() throws IOException {
        write(Handmade.litRoom(Vec3.ZERO).solution());
        byte[] once = Files.readAllBytes(file);
        write(Handmade.litRoom(Vec3.ZERO).solution());
        assertArrayEquals(once, Files.readAllBytes(file));
    }

    @Test
    void readSolution_writesTheSameLight() throws IOException {
        write(Handmade.litRoom(Vec3.ZERO).solution());
        Path again = folder.resolve("again.scene");
        try (SceneFile scene = SceneFile.open(file)) {
            SceneFile.write(again, scene.solution(), Map.of(), scene.camera(), TONES);
            try (SceneFile second = SceneFile.open(again)) {
                for (int i = 0; i < scene.meshes().size(); i++) {
                    assertArrayEquals(scene.meshes().get(i).irradiance(), second.meshes().get(i).irradiance());
                    assertArrayEquals(scene.meshes().get(i).corners(), second.meshes().get(i).corners());
                    assertArrayEquals(scene.meshes().get(i).positions(), second.meshes().get(i).positions());
                }
            }
        }
    }

    @Test
    void greyScene_hasThreeEqualChannels() throws IOException {
        Solution s = Handmade.litRoom(Vec3.ZERO).solution();
        double[] grey = new double[s.vertices()];
        Arrays.fill(grey, 2.5);
        EnergyLedger one = new EnergyLedger(new double[1], new double[1], new double[1], new double[1], new double[1]);
        write(new Solution(s.scene(), 1, s.positions(), grey, s.corners(), s.faceOf(), 0, 0, 0, one, SavedState.NONE));
        try (SceneFile scene = SceneFile.open(file)) {
            for (float h : scene.meshes().get(0).irradiance()) {
                assertEquals(2.5f, h);
            }
            assertEquals(1, scene.ledger().shot().length);
        }
    }

    @Test
    void emptySolution_isAValidFile() throws IOException {
        write(new Handmade().solution());
        try (SceneFile scene = SceneFile.open(file)) {
            assertEquals(List.of(), scene.meshes());
            assertEquals(0, scene.solution().elements());
        }
    }

    /** What shines does so in the file, too; nothing is said of what does not. */
    @Test
    void whatShines_comesBack() throws IOException {
        Specular glass = new Specular(new Rgb(.04, .1, .2), new Rgb(.9, .8, .7), .5, .25, 1.5, true);
        Handmade made = new Handmade();
        made.grid(made.surface(new Surface("glass", Rgb.BLACK, Rgb.grey(.5), false).with(Optional.of(glass))),
                Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0), 1, 1, p -> Rgb.grey(1));
        made.grid(made.surface("wall", .5), new Vec3(0, 0, 1), new Vec3(1, 0, 0), new Vec3(0, 1, 0), 1, 1,
                p -> Rgb.grey(1));
        write(made.solution());
        try (SceneFile scene = SceneFile.open(file)) {
            assertEquals(List.of(Optional.of(glass), Optional.empty()),
                    scene.meshes().stream().map(mesh -> mesh.surface().specular()).toList());
            assertEquals(Optional.of(glass), scene.solution().scene().surfaces().get(0).specular());
        }
        String json = new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
        assertEquals(json.indexOf("specular"), json.lastIndexOf("specular"));
    }

    @Test
    void shineThatCannotBe_isRefused() throws IOException {
        Handmade made = new Handmade();
        made.grid(made.surface(new Surface("glass", Rgb.BLACK, Rgb.grey(.5), false).with(Optional.of(
                new Specular(Rgb.grey(.5), Rgb.BLACK, .5, .25, 1.5, true)))), Vec3.ZERO, new Vec3(1, 0, 0),
                new Vec3(0, 1, 0), 1, 1, p -> Rgb.grey(1));
        write(made.solution());
        String text = new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
        for (String wrong : List.of("\"index\":0.0", "\"index\":1e9", "\"index\":\"x\"")) {
            String other = text.replace("\"index\":1.5", (wrong + "    ").substring(0, 11).strip());
            assertTrue(!other.equals(text));
            other = other.replace("\"thin\":true", "\"thin\":true" + " ".repeat(text.length() - other.length()));
            Files.write(file, other.getBytes(StandardCharsets.ISO_8859_1));
            try (SceneFile scene = SceneFile.open(file)) {
                String message = assertThrows(SceneFormatException.class, scene::meshes).getMessage();
                assertTrue(message.contains("/materials/0/extras"), message);
            }
        }
    }
}
