package radiosity;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import radiosity.input.SceneReader;
import radiosity.input.file.ReadOptions;
import radiosity.master.RemoteWorld;
import radiosity.output.image.SurfaceMaps;
import radiosity.rmi.HostAddress;
import radiosity.rmi.HostKey;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.RoundListener;
import radiosity.solver.World;

/**
 * The front of the library: reads a scene, calculates its radiosity, and hands the result over.
 *
 * <pre>{@code
 * Scene scene = Radiosity.read(Path.of("room.lws"), System.err::println);
 * RadiosityResult result = Radiosity.of(scene).accuracy(0.02).run(progress -> true);
 * result.writeScene(Path.of("room.scene"));
 * }</pre>
 *
 * <p>An object of this class holds what to calculate; each setter changes it and returns it. One object can run several
 * times. The result is the same to the last bit for any number of threads and hosts.
 */
public final class Radiosity {

    private static final double UNSHOT = 0.01;

    private final Scene scene;
    private RadiositySettings settings = RadiositySettings.defaults();
    private StopRule stop = new StopRule(Integer.MAX_VALUE, UNSHOT);
    private int threads = Runtime.getRuntime().availableProcessors();
    private List<HostAddress> hosts = List.of();
    private HostKey key;
    private Consumer<String> notices = line -> { };

    private Radiosity(Scene scene) {
        this.scene = scene;
    }

    /**
     * Reads a scene (LightWave, glTF or OBJ), the files that it names, and their images.
     *
     * @param file     a LightWave scene (.lws) or object (.lwo), glTF (.glb, .gltf), or OBJ (.obj); its content says
     *                 which, and its name where the content leaves that open
     * @param warnings gets one line for each kind of thing that was left out or mended
     * @throws IOException where the file cannot be read; a {@link radiosity.scene.SceneFormatException} where its
     *                     content cannot be used
     */
    public static Scene read(Path file, Consumer<String> warnings) throws IOException {
        return read(file, ReadOptions.defaults(), warnings);
    }

    /**
     * Reads a scene as the options say, see {@link #read(Path, Consumer)}.
     *
     * @param options which frame, which emission, where to search for objects and images
     */
    public static Scene read(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        return SurfaceMaps.read(SceneReader.read(file, options, warnings), options.srgb(), warnings);
    }

    /** A calculation for a scene, with default settings: an expected error of 2 %, all processors of this machine. */
    public static Radiosity of(Scene scene) {
        return new Radiosity(scene);
    }

    /**
     * Sets the error to aim at.
     *
     * @param error expected root mean square error of the radiosity relative to its mean, in (0, 1)
     * @return this calculation
     * @throws IllegalArgumentException for any other number
     */
    public Radiosity accuracy(double error) {
        if (!(error > 0 && error < 1)) {
            throw new IllegalArgumentException("accuracy: expected an error between 0 and 1 (0.02 is 2 %), got "
                    + error);
        }
        settings = settings.accurate(error);
        return this;
    }

    /**
     * Sets everything that {@link RadiositySettings} names, an accuracy that was set before included.
     *
     * @return this calculation
     */
    public Radiosity settings(RadiositySettings wanted) {
        settings = wanted;
        return this;
    }

    /**
     * Keeps the light of each lamp apart, so that a viewer can switch and dim the lamps.
     *
     * @return this calculation
     */
    public Radiosity layers() {
        settings = settings.layers(true);
        return this;
    }

    /**
     * Sets when to stop; without it, when 1 % of the emitted flux is left to be distributed.
     *
     * @return this calculation
     */
    public Radiosity stop(StopRule rule) {
        stop = rule;
        return this;
    }

    /**
     * Sets the number of threads of this process.
     *
     * @param number at least 1
     * @return this calculation
     * @throws IllegalArgumentException for a number below 1
     */
    public Radiosity threads(int number) {
        if (number < 1) {
            throw new IllegalArgumentException("threads: expected at least 1, got " + number);
        }
        threads = number;
        return this;
    }

    /**
     * Lets other machines calculate, on which {@code PartitionServer} runs.
     *
     * @param addresses at least one
     * @param secret    the key that all hosts know, or null where they run without one
     * @param lines     gets one line for each thing that the user should know about hosts
     * @return this calculation
     */
    public Radiosity hosts(List<HostAddress> addresses, HostKey secret, Consumer<String> lines) {
        hosts = List.copyOf(addresses);
        key = secret;
        notices = lines;
        return this;
    }

    /**
     * Calculates until the stop rule holds or the listener asks to stop.
     *
     * @param listener asked after every step whether to go on
     * @throws IOException                          where the hosts cannot be used
     * @throws radiosity.util.NoNumberException where light is so strong that it overflows
     */
    public RadiosityResult run(RoundListener listener) throws IOException {
        try (World world = hosts.isEmpty() ? new LocalWorld(scene, settings, threads)
                : new RemoteWorld(scene, settings, hosts, key, threads, notices)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, stop);
            radiosity.run(listener);
            return new RadiosityResult(radiosity.solution(), radiosity.certificate(threads), radiosity.progress());
        }
    }
}
