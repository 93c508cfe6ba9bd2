package radiosity.cli;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import radiosity.testkit.Program;

/** RadiosityRenderer that gives saving as many seconds after a signal as its first argument says. */
final class RendererWithPatience {

    /** More than saving takes on any machine. */
    static final int ENDLESS = 100_000;

    private RendererWithPatience() { }

    public static void main(String[] arguments) {
        System.exit(RadiosityRenderer.run(Duration.ofSeconds(Integer.parseInt(arguments[0])),
                Arrays.copyOfRange(arguments, 1, arguments.length)));
    }

    /**
     * The command of a process.
     *
     * @param patience  how long a signal waits for the end of saving, s
     * @param arguments separated by spaces
     */
    static List<String> command(int patience, String arguments) {
        List<String> command = new ArrayList<>(Program.command(arguments));
        int main = command.indexOf(RadiosityRenderer.class.getName());
        command.set(main, RendererWithPatience.class.getName());
        command.add(main + 1, Integer.toString(patience));
        return command;
    }
}
