package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import radiosity.bench.ReadAll;
import radiosity.scene.Scene;

/** What reading scenes asks of a virtual machine: little memory, and no class of a display. */
@Tag("slow")
@Timeout(value = 300, unit = TimeUnit.SECONDS)
class OwnMachineTest {

    @TempDir
    Path folder;

    @Test
    void hostileInputs_fitIn512MiB_andLoadNoClassOfADisplay() throws Exception {
        Path log = folder.resolve("classes.txt");
        String output = run(List.of("-Xmx512m", "-Xlog:class+load:file=" + log), folder.toString());
        assertTrue(output.endsWith(" triangles"), output);
        try (Stream<String> lines = Files.lines(log)) {
            List<String> display = lines.filter(l -> l.contains(" java.awt.") || l.contains("javax.swing")
                    || l.contains("javax.imageio") || l.contains("j3d") || l.contains("jogamp")).toList();
            assertEquals(List.of(), display);
        }
    }

    @Test
    void largeScenes_takeMemoryInProportion() throws Exception {
        Path terrain = LargeScenes.terrain(folder, 200);
        Path instances = LargeScenes.instances(folder, 50_000);
        assertEquals("80000 triangles", run(List.of("-Xmx48m"), folder.toString(), terrain.toString()));
        assertEquals("100000 triangles", run(List.of("-Xmx256m"), folder.toString(), instances.toString()));
    }

    @Test
    void moreTrianglesThanMemoryHolds_areOneLine() throws Exception {
        LargeScenes.terrain(folder, 200);
        Path many = Files.writeString(folder.resolve("many.lws"), "LWSC\n3\n"
                + "LoadObjectLayer 1 terrain.lwo\n".repeat(100));
        assertEquals("0 triangles", run(List.of("-Xmx256m"), folder.toString(), many.toString()));
    }

    @Test
    void filesOfOneThingOnly_takeMemoryInProportion() throws Exception {
        List<String> files = new ArrayList<>(List.of(folder.toString()));
        for (HostileCase bulk : BulkFiles.all()) {
            files.add(bulk.write(Files.createDirectory(folder.resolve(bulk.name()))).toString());
        }
        String output = run(List.of("-Xmx256m"), files.toArray(new String[0]));
        assertTrue(output.endsWith(" triangles"), output);
    }

    /** Runs the readers in a machine of their own and returns what it prints. */
    private static String run(List<String> options, String... arguments) throws Exception {
        List<String> command =
                new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        command.addAll(options);
        command.addAll(List.of("-cp", location(Scene.class) + System.getProperty("path.separator")
                + location(ReadAll.class), ReadAll.class.getName()));
        command.addAll(List.of(arguments));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String output = new String(process.getInputStream().readAllBytes()).trim();
        assertEquals(0, process.waitFor(), output);
        return output;
    }

    private static String location(Class<?> type) throws IOException, URISyntaxException {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
    }
}
