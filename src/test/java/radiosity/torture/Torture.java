package radiosity.torture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** {@code scripts/torture}: a campaign from the command line. */
public final class Torture {

    private static final Pattern SEED = Pattern.compile("(\\d+)(?:\\.(\\d+))?");
    private static final String EXPECTED =
            "expected MINUTES [--seed N[.RUN]] [--program DIR] [--parallel N] [--keep], got ";

    private double minutes = -1;
    private long seed = System.currentTimeMillis() % 1_000_000;
    /** The one run that is repeated, or -1 for all. */
    private int only = -1;
    private boolean keep;
    private int parallel = Math.max(1, Runtime.getRuntime().availableProcessors());
    private Subject subject = Subject.own();

    private Torture() {
    }

    /** @param arguments MINUTES [--seed N[.RUN]] [--program DIR] [--parallel N] [--keep] */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Torture torture = new Torture();
        try {
            torture.read(arguments);
        } catch (IllegalArgumentException | IOException e) {
            System.err.println("torture: " + e.getMessage());
            System.exit(2);
        }
        System.exit(torture.run() ? 0 : 1);
    }

    private void read(String[] arguments) throws IOException {
        for (int i = 0; i < arguments.length; i++) {
            boolean more = i + 1 < arguments.length;
            if (arguments[i].equals("--seed") && more) {
                Matcher parts = SEED.matcher(arguments[++i]);
                if (!parts.matches()) {
                    throw new IllegalArgumentException("--seed: expected a number, or one and a run's, got "
                            + arguments[i]);
                }
                seed = Long.parseLong(parts.group(1));
                only = parts.group(2) == null ? -1 : Integer.parseInt(parts.group(2));
            } else if (arguments[i].equals("--parallel") && more && arguments[i + 1].matches("[1-9]\\d?")) {
                parallel = Integer.parseInt(arguments[++i]);
            } else if (arguments[i].equals("--keep")) {
                keep = true;
            } else if (arguments[i].equals("--program") && more) {
                subject = Subject.of(Path.of(arguments[++i]));
            } else if (arguments[i].matches("\\d+(\\.\\d+)?") && minutes < 0) {
                minutes = Double.parseDouble(arguments[i]);
            } else {
                throw new IllegalArgumentException(EXPECTED + String.join(" ", arguments));
            }
        }
        if (minutes < 0) {
            throw new IllegalArgumentException(EXPECTED
                    + (arguments.length == 0 ? "nothing" : String.join(" ", arguments)));
        }
    }

    private boolean run() throws IOException, InterruptedException {
        Path directory = Files.createTempDirectory("torture");
        System.out.println("seed " + seed + ", files in " + directory);
        Runtime.getRuntime().addShutdownHook(new Thread(() -> ProcessHandle.current().descendants()
                .forEach(ProcessHandle::destroyForcibly), "ends what the campaign started"));
        Campaign campaign = new Campaign(subject, Menu.all(), directory, System.out, keep);
        long end = System.nanoTime() + (long) (minutes * 60e9);
        AtomicInteger runs = new AtomicInteger();
        campaign.run(seed, only, parallel, n -> {
            boolean more = n == 0 || System.nanoTime() < end;
            runs.addAndGet(more ? 1 : 0);
            return more;
        });
        if (only < 0) {
            campaign.tally().print(System.out);
            System.out.println();
        }
        System.out.println(runs + " runs, " + campaign.failed() + " failed"
                + (only >= 0 || campaign.tally().missing().isEmpty() ? ""
                : "; never: " + String.join(", ", campaign.tally().missing())));
        return campaign.failed() == 0;
    }
}
