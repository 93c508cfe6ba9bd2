package radiosity.torture;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The program that is tortured: a class path and the names of its main classes.
 *
 * @param classPath what java gets
 * @param renderer  main class of RadiosityRenderer
 * @param server    main class of PartitionServer
 * @param shipped   directory with the scenes that the project ships
 * @param java      options for java
 */
record Subject(String classPath, String renderer, String server, Path shipped, List<String> java) {

    /** A line of --help that begins with an option. */
    private static final Pattern OPTION = Pattern.compile("(?m)^  (--?[a-z][a-z-]*)");

    /** The program that this class was compiled with. */
    static Subject own() {
        return new Subject(System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                radiosity.cli.RadiosityRenderer.class.getName(), radiosity.cli.PartitionServer.class.getName(),
                Path.of("scenes").toAbsolutePath(), List.of());
    }

    /** The same with another main class for RadiosityRenderer. */
    Subject with(String main, List<String> options) {
        return new Subject(classPath, main, server, shipped, options);
    }

    /** Another checkout, built: its jar, or its classes with this one's libraries. */
    static Subject of(Path home) throws IOException {
        Path jar = home.resolve("target/radiosity.jar");
        Path classes = home.resolve("target/classes");
        Subject own = own();
        String path = Files.exists(jar) ? jar.toAbsolutePath().toString()
                : classes.toAbsolutePath() + File.pathSeparator + own.classPath;
        if (!Files.exists(jar) && !Files.isDirectory(classes)) {
            throw new IOException(home + ": expected a checkout with target/radiosity.jar or target/classes, got none");
        }
        return new Subject(path, own.renderer, own.server, home.resolve("scenes").toAbsolutePath(), List.of());
    }

    /** The same with its class directories and jars copied: a build in the meantime does it no harm. */
    Subject copied(Path to) throws IOException {
        Files.createDirectories(to);
        List<String> entries = new ArrayList<>();
        for (String entry : classPath.split(File.pathSeparator)) {
            Path from = Path.of(entry).toAbsolutePath();
            boolean changes = Files.isDirectory(from) || from.endsWith("target/radiosity.jar");
            entries.add((changes ? copy(from, to.resolve("program-" + entries.size())) : from).toString());
        }
        return new Subject(String.join(File.pathSeparator, entries), renderer, server,
                copy(shipped, to.resolve("scenes")), java);
    }

    private static Path copy(Path from, Path to) throws IOException {
        if (Files.notExists(from)) {
            return from;
        }
        try (Stream<Path> all = Files.walk(from)) {
            for (Path path : (Iterable<Path>) all::iterator) {
                Files.copy(path, Path.of(to + path.toString().substring(from.toString().length())),
                        StandardCopyOption.COPY_ATTRIBUTES);
            }
        }
        return to;
    }

    /** A command line of it; the class path stands in the environment ({@link #start}). */
    List<String> command(String mainClass, List<String> options, List<String> arguments) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(java);
        command.addAll(options);
        command.add("-Djava.awt.headless=true");
        command.add(mainClass);
        command.addAll(arguments);
        return command;
    }

    /** Starts a command; its output and errors come from {@link Process#getInputStream()}. */
    Process start(List<String> command, Path directory) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command).directory(directory.toFile()).redirectErrorStream(true);
        builder.environment().put("CLASSPATH", classPath);
        return builder.start();
    }

    /** The options that its --help names, each by its first name. */
    Set<String> options() throws IOException {
        Process help = start(command(renderer, List.of(), List.of("--help")), Path.of("").toAbsolutePath());
        String text = new String(help.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return OPTION.matcher(text).results().map(option -> option.group(1)).collect(Collectors.toSet());
    }
}
