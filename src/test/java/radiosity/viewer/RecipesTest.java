package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.net.httpserver.HttpServer;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.cli.RadiosityRenderer;
import radiosity.testkit.ProgramScript;

/** The commands of docs/RECIPES.md, word for word; its recipes that can be run show what {@code --picture} shows. */
@Tag("slow")
class RecipesTest {

    private static final Path RECIPES = Path.of("docs/RECIPES.md");
    private static final String NO_BLENDER = "no bpy: Blender's recipe is not tested (pip install bpy)";
    private static final int SIZE = 400;
    private static final String MODEL = "room-lit.glb";
    private static final Pattern THREE = Pattern.compile("/three/([\\w/.]+\\.js)");

    @TempDir
    static Path folder;

    private static BufferedImage picture;

    @BeforeAll
    static void render() throws IOException {
        assertEquals(0, RadiosityRenderer.run("-q", "--accuracy", "5%", "--lightmap", folder.resolve(MODEL).toString(),
                "--picture", folder.resolve("room.png").toString(), "--tone-mapping", "linear", "--size",
                SIZE + "x" + SIZE, "scenes/cornell-box.lws", folder.resolve("room.scene").toString()));
        picture = Rendered.picture(folder.resolve("room.png"));
    }

    private static String block(String language) throws IOException {
        Matcher block = Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL)
                .matcher(Files.readString(RECIPES));
        assertTrue(block.find(), "a block of " + language);
        return block.group(1);
    }

    private static void assertSame(BufferedImage shown) {
        double difference = Rendered.difference(picture, shown);
        assertTrue(difference <= 3, "mean difference " + difference + " of 255");
        int seam = seam(shown);
        assertTrue(seam <= 4, "a seam of " + seam + " of 255");
        System.out.printf("recipe: mean difference %.2f, seams %d of 255%n", difference, seam);
    }

    /** The largest step between neighbours that the picture does not have, far from edges of the picture's own. */
    private static int seam(BufferedImage shown) {
        int most = 0;
        for (int y = 3; y < SIZE - 3; y++) {
            for (int x = 3; x < SIZE - 3; x++) {
                for (int shift = 0; shift < 24 && isSmooth(x, y); shift += 8) {
                    int here = off(shown, x, y, shift);
                    most = Math.max(most, Math.abs(here - off(shown, x + 1, y, shift)));
                    most = Math.max(most, Math.abs(here - off(shown, x, y + 1, shift)));
                }
            }
        }
        return most;
    }

    private static int channel(BufferedImage image, int x, int y, int shift) {
        return image.getRGB(x, y) >> shift & 0xFF;
    }

    private static int off(BufferedImage shown, int x, int y, int shift) {
        return channel(shown, x, y, shift) - channel(picture, x, y, shift);
    }

    private static boolean isSmooth(int x, int y) {
        for (int shift = 0; shift < 24; shift += 8) {
            int least = 255;
            int most = 0;
            for (int i = 0; i < 49; i++) {
                int value = channel(picture, x - 3 + i % 7, y - 3 + i / 7, shift);
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
            if (most - least > 10) {
                return false;
            }
        }
        return true;
    }

    /** Serves the recipe's page, three.js, and what lies in the folder. */
    private static HttpServer server() throws IOException {
        String page = block("html").replaceFirst("</script>\\s*$", "document.body.dataset.ready = 'yes';</script>");
        HttpServer server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.createContext("/", exchange -> {
            String path = exchange.getRequestURI().getPath();
            Matcher three = THREE.matcher(path);
            byte[] bytes = new byte[0];
            if (path.equals("/")) {
                bytes = page.getBytes(StandardCharsets.UTF_8);
            } else if (three.matches()) {
                try (InputStream in = RecipesTest.class.getResourceAsStream(
                        "/META-INF/resources/webjars/three/0.181.1/" + three.group(1))) {
                    bytes = in.readAllBytes();
                }
            } else if (path.equals("/" + MODEL)) {
                bytes = Files.readAllBytes(folder.resolve(MODEL));
            }
            exchange.getResponseHeaders().set("Content-Type", path.equals("/") ? "text/html; charset=utf-8"
                    : three.matches() ? "text/javascript; charset=utf-8" : "application/octet-stream");
            exchange.sendResponseHeaders(bytes.length > 0 ? 200 : 204, bytes.length > 0 ? bytes.length : -1);
            exchange.getResponseBody().write(bytes);
            exchange.close();
        });
        server.start();
        return server;
    }

    @Test
    void threeJs_showsTheSame() throws Exception {
        HttpServer server = server();
        try (Browser browser = new Browser(Files.createDirectory(folder.resolve("profile")), SIZE)) {
            browser.open(URI.create("http://localhost:" + server.getAddress().getPort() + "/"));
            assertEquals(List.of(), browser.errors);
            assertSame(browser.screenshot());
        } finally {
            server.stop(0);
        }
    }

    /** The document's commands, in their order: its indented lines outside of blocks of code. */
    static List<String> commands() throws IOException {
        String prose = Files.readString(RECIPES).replaceAll("(?ms)^```.*?^```$", "");
        return prose.lines().filter(line -> line.startsWith("    ")).map(String::strip).toList();
    }

    /** Each command finds, or makes, every file that it names. */
    @ParameterizedTest
    @MethodSource("commands")
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "runs a shell's commands")
    void everyCommand_works(String command) throws Exception {
        Path user = folder.resolve("user");
        if (Files.notExists(user)) {
            ProgramScript.write(user, RadiosityRenderer.class);
            ProgramScript.write(user.resolve("bin/python"), "python3");
            Files.copy(Path.of("src/test/resources/radiosity/input/room.glb"), user.resolve("room.glb"));
            Files.writeString(user.resolve("blender.py"), block("python"));
        }
        assumeTrue(!command.startsWith("python ") || hasBlender(), NO_BLENDER);
        ProcessBuilder shell = new ProcessBuilder("sh", "-c", "PATH=bin:$PATH; " + command).directory(user.toFile())
                .redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile());
        assertEquals(0, shell.start().waitFor(), command + ": " + Files.readString(folder.resolve("log")));
        for (String word : command.split(" ")) {
            assertTrue(!word.contains(".") || Files.size(user.resolve(word)) > 0, word);
        }
    }

    @Test
    void blender_showsTheSame() throws Exception {
        assumeTrue(hasBlender(), NO_BLENDER);
        Path script = Files.writeString(folder.resolve("blender.py"), block("python"));
        Path shown = folder.resolve("room-blender.png");
        assertEquals(0, run("python3", script.toString(), folder.resolve(MODEL).toString(), shown.toString(),
                "" + SIZE, "" + SIZE));
        assertSame(Rendered.picture(shown));
    }

    private static boolean hasBlender() throws InterruptedException {
        return run("python3", "-c", "import bpy") == 0;
    }

    private static int run(String... command) throws InterruptedException {
        try {
            return new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile())
                    .start().waitFor();
        } catch (IOException e) {
            return -1;
        }
    }
}
