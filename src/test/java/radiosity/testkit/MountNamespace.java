package radiosity.testkit;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Shell scripts that mount file systems which only they and the programs they start see, and which end with them.
 *
 * <p>Needs Linux and either root or user namespaces; tests are skipped where these are missing.
 */
public final class MountNamespace {

    private static final List<String> SHELL = List.of("unshare", "-rm", "sh", "-c");

    private MountNamespace() { }

    /** A command that runs a script; {@code "$@"} in the script is the given command. */
    public static List<String> command(String script, List<String> command) throws InterruptedException {
        assumeTrue(worksHere(), "needs a mount namespace (unshare -rm): full and read-only disks are not tested");
        List<String> words = new ArrayList<>(SHELL);
        words.addAll(List.of(script, "sh"));
        words.addAll(command);
        return words;
    }

    /** Commands that mount a small disk over an empty directory and move the files of another directory there. */
    public static String disk(String directory, String files) {
        return "mount -t tmpfs -o size=4m none " + directory + " && cp " + files + "/* " + directory + " && rm "
                + files + "/* || exit 99; ";
    }

    /** Commands that make a file one that nobody may write or replace. */
    public static String readOnly(String file) {
        return "mount --bind " + file + " " + file + " && mount -o remount,bind,ro " + file + " || exit 99; ";
    }

    private static boolean worksHere() throws InterruptedException {
        List<String> command = new ArrayList<>(SHELL);
        command.add("mount -t tmpfs none /tmp");
        try {
            return new ProcessBuilder(command).redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD).start().waitFor() == 0;
        } catch (IOException e) {
            return false;
        }
    }
}
