package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.options.ExitCode;
import radiosity.input.lightwave.HostileCase;
import radiosity.input.lightwave.HostileFilesTest;
import radiosity.testkit.Program;
import radiosity.testkit.ProgramRun;

/** Every kind of broken and hostile input goes through the whole program, in a machine of 512 MiB. */
@Tag("slow")
class HostileProgramTest {

    private static final Set<Integer> ALLOWED = Set.of(ExitCode.DONE, ExitCode.FILE);
    private static final Pattern JAVA = Pattern.compile("Exception|Error\\b|\\bat radiosity\\.|internal error|\\bnull\\b");
    /** CPU seconds from which a case is named in the report. */
    private static final double LONG = 1;

    @TempDir
    Path folder;

    /**
     * The machine.
     *
     * @param arguments a folder to write into
     */
    public static void main(String[] arguments) throws IOException {
        System.setProperty("java.awt.headless", "true");
        for (HostileCase hostile : (Iterable<HostileCase>) HostileFilesTest.cases()::iterator) {
            Path folder = Files.createTempDirectory(Path.of(arguments[0]), "case");
            double begin = cpu();
            Path output = folder.resolve("out.scene");
            ProgramRun run = ProgramRun.of("-it", 1, "-q", "-t", 1, hostile.write(folder), output);
            System.out.println(String.join("\t", "case", hostile.name(),
                    String.format(Locale.ROOT, "%.2f", cpu() - begin), "" + run.exitCode(), "" + Files.exists(output),
                    (run.out() + run.err()).replace('\n', '|').replace('\t', ' ')));
            delete(folder);
        }
    }

    private static double cpu() {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime() * 1e-9;
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(path);
            }
        }
    }

    /** CPU time is printed and not asserted. */
    @Test
    @Timeout(value = 600, unit = TimeUnit.SECONDS)
    void everyHostileInput_isRenderedOrRefusedInPlainLines() throws Exception {
        List<String> command = new ArrayList<>(Program.command(folder.toString()));
        command.set(command.size() - 2, HostileProgramTest.class.getName());
        command.add(1, "-Xmx512m");
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), printed);
        List<String> wrong = new ArrayList<>();
        List<String[]> cases = printed.lines().filter(line -> line.startsWith("case\t")).map(line -> line.split("\t", 6))
                .toList();
        cases.forEach(one -> check(one, wrong));
        assertEquals(List.of(), wrong);
        assertEquals(HostileFilesTest.cases().count(), cases.size(), printed);
    }

    private static void check(String[] one, List<String> wrong) {
        if (Double.parseDouble(one[2]) >= LONG) {
            System.out.println(one[1] + ": " + one[2] + " CPU-s");
        }
        int code = Integer.parseInt(one[3]);
        boolean sound = ALLOWED.contains(code) && Boolean.parseBoolean(one[4]) == (code == ExitCode.DONE)
                && !JAVA.matcher(one[5]).find() && (code == ExitCode.DONE || one[5].contains(": expected "));
        if (!sound) {
            wrong.add(String.join(" ", one));
        }
    }
}
