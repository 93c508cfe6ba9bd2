package radiosity;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import radiosity.input.SceneReader;
import radiosity.master.RemoteWorld;
import radiosity.output.image.SurfaceMaps;
import radiosity.rmi.HostAddress;
import radiosity.rmi.HostKey;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.ReadOptions;
import radiosity.settings.StopRule;
import radiosity.solution.RoundListener;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
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
    private SavedState state = SavedState.NONE;
    private Solution earlier;
    private Consumer<String> anew;
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
     * @param addresses at least one {@code host} or {@code host:port}
     * @param lines     gets one line for each thing that the user should know about hosts
     * @return this calculation
     * @throws IllegalArgumentException for an address that is neither
     */
    public Radiosity hosts(List<String> addresses, Consumer<String> lines) {
        hosts = addresses.stream().map(HostAddress::parse).toList();
        notices = lines;
        return this;
    }

    /**
     * Lets only hosts calculate that know the same key, and nobody else read along.
     *
     * @param file as {@code scripts/make-key} makes it
     * @return this calculation
     * @throws IOException where the file cannot be read or holds no key
     */
    public Radiosity key(Path file) throws IOException {
        key = HostKey.read(file);
        return this;
    }

    /**
     * Goes on from where an earlier calculation of the same scene with the same settings stopped, to the same bits as
     * without the stop.
     *
     * @param earlier {@link radiosity.solution.Solution#state} of the earlier result
     * @return this calculation
     */
    public Radiosity resume(SavedState earlier) {
        state = earlier;
        return this;
    }

    /**
     * Goes on from the solution of an earlier state of the scene, with the same settings: only the light that changed
     * objects, materials and lamps take away or bring is calculated. Where too much has changed, all of it is, and a
     * line says why.
     *
     * @param before of an earlier result
     * @param lines  gets at most one line
     * @return this calculation
     */
    public Radiosity change(Solution before, Consumer<String> lines) {
        earlier = before;
        anew = lines;
        return this;
    }

    /**
     * Calculates until the stop rule holds or the listener asks to stop.
     *
     * @param listener asked after every step whether to go on
     * @throws IOException         where the hosts cannot be used; a {@link radiosity.scene.SceneFormatException} where
     *                             the state to go on from is of another scene or of other settings
     * @throws ArithmeticException where light is so strong that it overflows
     */
    public RadiosityResult run(RoundListener listener) throws IOException {
        try (World world = hosts.isEmpty() ? new LocalWorld(scene, settings, threads)
                : new RemoteWorld(scene, settings, hosts, key, threads, notices)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, stop);
            if (!state.isEmpty()) {
                radiosity.resume(state);
            } else if (earlier != null) {
                radiosity.change(earlier.state()).ifPresent(why ->
                        anew.accept("the scene is rendered anew, as " + why));
            }
            radiosity.run(listener);
            return new RadiosityResult(radiosity.solution(), radiosity.certificate(threads), radiosity.progress());
        }
    }
}
