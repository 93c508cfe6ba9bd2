package radiosity.testkit;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** A display in memory; tests that need one are skipped where Xvfb is not installed. */
public final class Xvfb implements AutoCloseable {

    private static final String[] EXPORTS = {"java.base/java.lang", "java.desktop/sun.awt", "java.desktop/sun.java2d"};

    private final Process server;
    private final String display;

    public Xvfb() throws IOException {
        assumeTrue(installed("Xvfb"), "Xvfb is not installed: windows are not tested (apt-get install xvfb"
                + " libgl1-mesa-dri libgl1)");
        server = new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", "1024x768x24", "-nolisten", "tcp")
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
        String number = new BufferedReader(new InputStreamReader(server.getInputStream())).readLine();
        assumeTrue(number != null, "Xvfb does not start: windows are not tested");
        display = ":" + number;
    }

    private static boolean installed(String program) {
        return Stream.of(System.getenv("PATH").split(File.pathSeparator))
                .anyMatch(directory -> Files.isExecutable(Path.of(directory, program)));
    }

    /** A program of ours as a process of its own, with what scripts/ViewSceneFile gives it. */
    public static ProcessBuilder java(Class<?> main, String... arguments) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        for (String export : EXPORTS) {
            command.add("--add-exports");
            command.add(export + "=ALL-UNNAMED");
        }
        command.addAll(List.of("-Xmx2g", "-cp", System.getProperty("surefire.test.class.path",
                System.getProperty("java.class.path")), main.getName()));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command);
    }

    /** As {@link #java}, on this display. */
    public ProcessBuilder program(Class<?> main, String... arguments) {
        return command(java(main, arguments).command());
    }

    /** Any command, on this display. */
    public ProcessBuilder command(List<String> command) {
        ProcessBuilder builder = new ProcessBuilder(command);
        builder.environment().put("DISPLAY", display);
        return builder;
    }

    @Override
    public void close() {
        server.destroy();
    }
}
