package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.ConnectException;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.RadiosityRenderer;
import radiosity.cli.ViewSceneFile;
import radiosity.testkit.ProgramScript;

/** The commands of docs/TUTORIAL.md, one after the other, as they stand there but for the ports. */
@Tag("slow")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "runs a shell's commands")
class TutorialTest {

    private static final Path MODEL = Path.of("src/test/resources/radiosity/input/room.glb");

    @TempDir
    Path folder;

    private static List<String> commands() throws IOException {
        try (Stream<String> lines = Files.lines(Path.of("docs/TUTORIAL.md"))) {
            return lines.filter(line -> line.startsWith("    ")).map(String::strip).toList();
        }
    }

    private Process start(String command) throws IOException {
        return new ProcessBuilder("sh", "-c", command).directory(folder.toFile()).redirectErrorStream(true)
                .redirectOutput(folder.resolve("printed").toFile()).start();
    }

    private static void end(Process process) {
        List<ProcessHandle> all = new ArrayList<>(process.descendants().toList());
        all.add(process.toHandle());
        all.forEach(ProcessHandle::destroy);
    }

    @Test
    void everyCommand_works_andThePageShowsTheRoom() throws Exception {
        ProgramScript.write(folder, RadiosityRenderer.class);
        ProgramScript.write(folder, ViewSceneFile.class);
        Files.copy(MODEL, folder.resolve("room.glb"));
        Files.createSymbolicLink(folder.resolve("docs"), Path.of("docs").toAbsolutePath());
        for (String command : commands()) {
            if (command.contains("--web")) {
                servesAPage(command.replace("--web", "--web --port 0"));
            } else if (command.contains("http.server")) {
                showsTheRoom(command);
            } else {
                int code = start(command).waitFor();
                assumeTrue(code == 0 || !command.startsWith("npm"), "no npm: the tutorial's page is not tested");
                assertEquals(0, code, command + ": " + Files.readString(folder.resolve("printed")));
            }
        }
        for (String made : List.of("first.png", "room.png", "room-lit.glb", "room-lit-lightmap.exr", "room.scene")) {
            assertTrue(Files.size(folder.resolve(made)) > 1000, made);
        }
    }

    private void servesAPage(String command) throws IOException {
        Process server = new ProcessBuilder("sh", "-c", command).directory(folder.toFile()).start();
        try (BufferedReader out = server.inputReader()) {
            URI page = URI.create(out.readLine());
            assertTrue(new String(page.toURL().openStream().readAllBytes()).contains("<html"), page.toString());
        } finally {
            end(server);
        }
    }

    private static void awaitServer(int port) throws Exception {
        for (int i = 0; i < 600; i++) {
            try (Socket connection = new Socket("localhost", port)) {
                return;
            } catch (ConnectException e) {
                Thread.sleep(100);
            }
        }
        throw new IllegalStateException("the tutorial's server does not answer after 60 s");
    }

    private void showsTheRoom(String command) throws Exception {
        int port;
        try (ServerSocket free = new ServerSocket(0)) {
            port = free.getLocalPort();
        }
        Path index = folder.resolve("index.html");
        Files.writeString(index, Files.readString(index).replaceFirst("</script>\\s*$",
                "document.body.dataset.ready = 'yes';</script>"));
        Process server = start("exec " + command.replace("8000", "" + port));
        try (Browser browser = new Browser(Files.createDirectory(folder.resolve("profile")), 300)) {
            awaitServer(port);
            browser.open(URI.create("http://localhost:" + port + "/"));
            assertTrue(Rendered.black(browser.screenshot()) < .1, "the room is lit");
        } finally {
            end(server);
        }
    }
}
