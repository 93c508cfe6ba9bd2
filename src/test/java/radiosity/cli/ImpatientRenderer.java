package radiosity.cli;

import java.time.Duration;

/** RadiosityRenderer that gives saving three seconds after a signal. */
final class ImpatientRenderer {

    private ImpatientRenderer() { }

    public static void main(String[] arguments) {
        System.exit(RadiosityRenderer.run(Duration.ofSeconds(3), arguments));
    }
}
