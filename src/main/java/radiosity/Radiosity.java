package radiosity;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import radiosity.input.SceneReader;
import radiosity.master.RemoteWorld;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.SurfaceMaps;
import radiosity.rmi.HostAddress;
import radiosity.rmi.HostKey;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;
import radiosity.solution.RoundListener;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.World;

/**
 * The front of the library: reads a scene, calculates its radiosity, and returns the result.
 *
 * <pre>{@code
 * Scene scene = Radiosity.read(Path.of("room.lws"), System.err::println);
 * RadiosityResult result = Radiosity.of(scene).accuracy(0.02).run(progress -> true);
 * result.writeScene(Path.of("room.scene"));
 * }</pre>
 *
 * <p>An object of this class holds a scene and settings; each setter changes a setting and returns the object. One
 * object can run several times, one thread at a time. The result is the same to the last bit for any number of threads
 * and hosts.
 */
public final class Radiosity {

    private final Scene scene;
    private RadiositySettings settings = RadiositySettings.defaults();
    private StopRule stop = new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT);
    private int threads = Runtime.getRuntime().availableProcessors();
    private List<HostAddress> hosts = List.of();
    private HostKey key;
    private SavedState state = SavedState.NONE;
    /** State of the solution of an earlier version of the scene; null for none. */
    private SavedState earlier;
    private Consumer<String> anew;
    private Consumer<String> notices = line -> { };

    private Radiosity(Scene scene) {
        this.scene = scene;
    }

    /**
     * Reads a scene (LightWave, glTF or OBJ), the files that it names, and their images.
     *
     * @param file     a LightWave scene (.lws) or object (.lwo), glTF (.glb, .gltf), or OBJ (.obj); the format is
     *                 recognised by the file's content, or else by its name
     * @param warnings receives one line for each kind of content that was left out or mended
     * @throws IOException where the file cannot be read; a {@link radiosity.scene.SceneFormatException} where its
     *                     content cannot be used
     */
    public static Scene read(Path file, Consumer<String> warnings) throws IOException {
        return read(file, ReadOptions.defaults(), warnings);
    }

    /**
     * Reads a scene with options, see {@link #read(Path, Consumer)}.
     *
     * @param options frame, emission, directories to search for objects and images, limits
     */
    public static Scene read(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        return SurfaceMaps.read(SceneReader.read(file, options, warnings), options.srgb(), warnings);
    }

    /** A calculation for a scene, with default settings: an expected error of 2 %, all processors of this machine. */
    public static Radiosity of(Scene scene) {
        return new Radiosity(scene);
    }

    /**
     * Sets the error that the calculation is to reach.
     *
     * @param error expected root mean square error of the radiosity relative to its mean, in (0, 1)
     * @return this calculation
     * @throws IllegalArgumentException for any other number, or NaN, and after {@link #settings} of a schedule that
     *                                  ends by a {@link StopRule} only, not by an error
     */
    public Radiosity accuracy(double error) {
        if (!(error > 0 && error < 1)) {
            throw new IllegalArgumentException("accuracy: expected an error between 0 and 1 (0.02 is 2 %), got "
                    + error);
        }
        if (settings.schedule() != Schedule.PREDICT) {
            throw new IllegalArgumentException("accuracy: expected settings of the schedule PREDICT, got "
                    + settings.schedule());
        }
        settings = settings.accurate(error);
        return this;
    }

    /**
     * Sets all of {@link RadiositySettings}, and so replaces an accuracy or layers set before.
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
     * Sets when to stop; the default is a thousandth of the emitted flux unshot, or the accuracy asked for.
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
     * Distributes the calculation to other machines, on which {@code PartitionServer} runs.
     *
     * @param addresses at least one {@code host} or {@code host:port}
     * @param lines     receives one line for each event that concerns a host, such as its loss
     * @return this calculation
     * @throws IllegalArgumentException for an address that is neither
     */
    public Radiosity hosts(List<String> addresses, Consumer<String> lines) {
        hosts = addresses.stream().map(HostAddress::parse).toList();
        notices = lines;
        return this;
    }

    /**
     * Accepts only hosts that know the same key, and encrypts the traffic to them.
     *
     * @param file a file made by {@code scripts/make-key}
     * @return this calculation
     * @throws IOException where the file cannot be read or holds no key
     */
    public Radiosity key(Path file) throws IOException {
        key = HostKey.read(file);
        return this;
    }

    /**
     * Goes on from the end of an earlier calculation of the same scene with the same settings. The result has the same
     * bits as without the interruption.
     *
     * @param earlier {@link radiosity.solution.Solution#state} of the earlier result
     * @return this calculation
     */
    public Radiosity resume(SavedState earlier) {
        state = earlier;
        return this;
    }

    /**
     * Goes on from a scene file that holds an earlier calculation, see {@link #resume(SavedState)}.
     *
     * @param stopped a scene file, as {@link RadiosityResult#writeScene} or the program writes it
     * @return this calculation
     * @throws IOException where the file cannot be read
     */
    public Radiosity resume(Path stopped) throws IOException {
        state = state(stopped);
        return this;
    }

    private static SavedState state(Path file) throws IOException {
        try (SceneFile saved = SceneFile.open(file)) {
            return saved.state();
        }
    }

    /**
     * Goes on from the solution of an earlier version of the scene, with the same settings: only the light that changed
     * objects, materials and lamps take away or add is calculated. Where too much has changed, all light is calculated,
     * and a line says why.
     *
     * @param before the solution of the earlier version
     * @param lines  receives at most one line
     * @return this calculation
     */
    public Radiosity change(Solution before, Consumer<String> lines) {
        earlier = before.state();
        anew = lines;
        return this;
    }

    /**
     * Goes on from the solution of an earlier version of the scene, see {@link #change(Solution, Consumer)}.
     *
     * @param before a scene file with that solution
     * @throws IOException where the file cannot be read
     */
    public Radiosity change(Path before, Consumer<String> lines) throws IOException {
        earlier = state(before);
        anew = lines;
        return this;
    }

    /**
     * Calculates until the stop rule holds or the listener asks to stop.
     *
     * @param listener asked after every step whether to go on
     * @return the solution so far, also where the listener stopped the calculation
     * @throws IOException         where the hosts cannot be used; a {@link radiosity.scene.SceneFormatException} where
     *                             the state to go on from belongs to another scene or to other settings
     * @throws ArithmeticException where the light is so strong that a number overflows
     * @throws IllegalArgumentException where the light of more than {@link RadiositySettings#MOST_LAMPS} lamps is to be
     *                             kept apart, or arrays cannot hold the patches that the settings ask for
     */
    public RadiosityResult run(RoundListener listener) throws IOException {
        int lamps = scene.lamps().size();
        if (settings.layers() && lamps > RadiositySettings.MOST_LAMPS) {
            throw new IllegalArgumentException("layers: expected a scene of at most " + RadiositySettings.MOST_LAMPS
                    + " lamps, got " + lamps);
        }
        try (World world = hosts.isEmpty() ? new LocalWorld(scene, settings, threads)
                : new RemoteWorld(scene, settings, hosts, key, threads, notices)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, stop);
            if (!state.isEmpty()) {
                radiosity.resume(state);
            } else if (earlier != null) {
                radiosity.change(earlier).ifPresent(why ->
                        anew.accept("the scene is rendered anew, as " + why));
            }
            boolean[] stopped = {false};
            radiosity.run(new RoundListener() {
                @Override
                public boolean afterRound(Progress progress) {
                    stopped[0] = !listener.afterRound(progress);
                    return !stopped[0];
                }

                @Override
                public boolean afterEstimate(Progress progress) throws IOException {
                    return listener.afterEstimate(progress);
                }
            });
            return new RadiosityResult(radiosity.solution(),
                    stopped[0] ? radiosity.knownCertificate() : radiosity.certificate(threads), radiosity.progress());
        }
    }
}
