package radiosity.testkit;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import radiosity.cli.RadiosityRenderer;

/** RadiosityRenderer as a process of its own, in a directory that holds foobar.lws, the Cornell box. */
public final class Program {

    private final Path directory;

    public Program(Path directory) throws IOException {
        this.directory = directory;
        Files.copy(Path.of("scenes/cornell-box.lws"), directory.resolve("foobar.lws"));
        Files.copy(Path.of("scenes/cornell-box.lwo"), directory.resolve("cornell-box.lwo"));
    }

    /** {@code java ... RadiosityRenderer}, then the arguments, separated by spaces. */
    public static List<String> command(String arguments) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.add("-cp");
        command.add(System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")));
        command.add(RadiosityRenderer.class.getName());
        command.addAll(List.of(arguments.split(" ")));
        return command;
    }

    /** Starts it; its output and errors come from {@link Process#getInputStream()}. */
    public Process start(List<String> command) throws IOException {
        return new ProcessBuilder(command).directory(directory.toFile()).redirectErrorStream(true).start();
    }

    public Process start(String arguments) throws IOException {
        return start(command(arguments));
    }

    public Path file(String name) {
        return directory.resolve(name);
    }

    /** Reads what a process prints until a word comes. */
    public static String readUntil(Process process, String word) throws IOException {
        StringBuilder text = new StringBuilder();
        InputStream in = process.getInputStream();
        for (int c = in.read(); c >= 0 && text.indexOf(word) < 0; c = in.read()) {
            text.append((char) c);
        }
        return text.toString();
    }

    public static String rest(Process process) throws IOException {
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
}
