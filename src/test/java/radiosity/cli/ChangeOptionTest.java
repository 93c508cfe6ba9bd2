package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.render.SavedCalculation;
import radiosity.output.gltf.LitScene;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Specular;
import radiosity.testkit.ProgramRun;

/** What {@code --change} takes over, and what it says where it cannot. */
@Tag("slow")
class ChangeOptionTest {

    private static final String EMPTY = "scenes/cornell-box-empty.lws";
    private static final String BOX = "scenes/cornell-box.lws";

    @TempDir
    Path directory;

    private ProgramRun render(Object... arguments) {
        Object[] words = new Object[arguments.length + 3];
        words[0] = "-q";
        words[1] = "-pa";
        words[2] = "20000";
        System.arraycopy(arguments, 0, words, 3, arguments.length);
        ProgramRun run = ProgramRun.of(words);
        assertEquals(0, run.exitCode(), run.err());
        return run;
    }

    @Test
    void oldSolution_isTakenOverOrALineSaysWhyNot() throws IOException {
        Path old = directory.resolve("old.scene");
        Path paper = directory.resolve("paper.scene");
        Path now = directory.resolve("now.scene");
        render("--accuracy", "50%", EMPTY, old);
        render("-it", "5", EMPTY, paper);

        assertEquals("", render("--change", old, EMPTY, now).err());
        assertEquals(SavedCalculation.read(old).state(), SavedCalculation.read(now).state());
        assertEquals("", render("--change", old, BOX, now).err());

        assertEquals(old + ": the scene is rendered anew, as the old solution was made with other settings\n",
                render("--change", old, "--accuracy", "40%", BOX, now).err());
        assertEquals(paper + ": the scene is rendered anew, as only solutions of --schedule predict and --form-factors"
                + " raycast are changed\n", render("--change", paper, "-it", "5", BOX, now).err());
    }

    private List<float[]> light(Path file) throws IOException {
        return LitScene.read(file).meshes().stream().map(Mesh::radiosity).toList();
    }

    /** Halves the number of a LightWave surface, a float after 2 bytes of length. */
    private static void halve(byte[] object, String chunk) {
        int at = new String(object, StandardCharsets.ISO_8859_1).indexOf(chunk) + chunk.length() + 2;
        ByteBuffer bytes = ByteBuffer.wrap(object);
        bytes.putFloat(at, bytes.getFloat(at) / 2);
    }

    /** The mirror mirrors half as much and the glass lets half through, which only pictures show. */
    @Test
    void whatShinesOtherwise_keepsTheBitsOfTheLight() throws IOException {
        Path before = directory.resolve("before.scene");
        Path anew = directory.resolve("anew.scene");
        Path changed = directory.resolve("changed.scene");
        Path scene = Files.copy(Path.of("scenes/cornell-mirror.lws"), directory.resolve("cornell-mirror.lws"));
        Files.copy(Path.of("scenes/cornell-box.lwo"), directory.resolve("cornell-box.lwo"));
        byte[] object = Files.readAllBytes(Path.of("scenes/cornell-mirror.lwo"));
        Files.write(directory.resolve("cornell-mirror.lwo"), object);
        render("--accuracy", "50%", scene, before);
        halve(object, "REFL");
        halve(object, "TRAN");
        Files.write(directory.resolve("cornell-mirror.lwo"), object);
        render("--accuracy", "50%", scene, anew);
        String said = render("--change", before, scene, changed).err();
        assertFalse(said.contains("anew"), said);

        for (Path file : List.of(anew, changed)) {
            assertNotEquals(shine(before), shine(file));
            assertArrayEquals(light(before).toArray(), light(file).toArray());
            assertEquals(SavedCalculation.read(before).state(), SavedCalculation.read(file).state());
        }
    }

    private static List<Optional<Specular>> shine(Path file) throws IOException {
        return LitScene.read(file).meshes().stream().map(mesh -> mesh.surface().specular()).toList();
    }

    @Test
    void filesThatAreNone_areErrors() {
        Path none = directory.resolve("none.scene");
        ProgramRun run = ProgramRun.of("--change", none, EMPTY, directory.resolve("a.scene"));
        assertEquals(3, run.exitCode());
        assertTrue(run.err().startsWith(none.toString()), run.err());
        assertEquals(3, ProgramRun.of("--change", EMPTY, EMPTY, directory.resolve("a.scene")).exitCode());
        assertEquals(2, ProgramRun.of("--change", none, "-tf", none, EMPTY, directory.resolve("a.scene")).exitCode());
    }
}
