package radiosity.torture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import radiosity.input.SceneReader;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;

/**
 * A valid choice of RadiosityRenderer's options.
 *
 * <p>One of them is given: it is always among them, and whatever it does not go with is not.
 */
final class RandomCommand {

    /** The options that a campaign uses, each by the first name that --help has for it. */
    static final List<String> OPTIONS = List.of("-pa", "-nr", "-mt", "-it", "-se", "--schedule", "--accuracy", "--time",
            "--estimates", "--form-factors", "--layers", "-t", "-dr", "-si", "-tf", "--points", "--grid", "--spacing",
            "--info",
            "--change", "--report", "-sn", "--lightmap", "--lightmap-texels", "--false-colour", "--picture", "--size",
            "--exposure", "--tone-mapping", "--final-gather", "--frame", "--frames", "--content", "--map", "--emission",
            "--lights", "--srgb", "--two-sided", "--up", "--unit", "--photometric", "--leave-out", "--luminaire",
            "--sky", "--sun", "--strict", "-h", "-key", "-ut", "-q", "--statistics", "--debug", "--help",
            "--version");
    /** Those that decide the light; the others go without or are where a run needs them. */
    private static final Set<String> RUN = Set.of("-t", "-tf", "--change", "--frames", "--info", "-h", "-key",
            "--statistics", "--help", "--version");

    private final Dice dice;
    private final Path directory;
    private final MadeScene scene;
    private final String wanted;
    private final Set<String> known;
    /** What decides the light. */
    private final Map<String, List<String>> light = new LinkedHashMap<>();
    /** What else is written, and how much is told. */
    private final Map<String, List<String>> rest = new LinkedHashMap<>();
    final Set<String> runOptions = new TreeSet<>();
    /** Whether the clock ends it. */
    boolean timed;
    /** The value of --schedule that is given or meant. */
    String schedule;

    /**
     * @param wanted    the option that must be there
     * @param known     options that the program has
     * @param directory for files that options name
     */
    RandomCommand(Dice dice, MadeScene scene, String wanted, Set<String> known, Path directory) throws IOException {
        this.dice = dice;
        this.directory = directory;
        this.scene = scene;
        this.wanted = wanted;
        this.known = known;
        reading();
        calculation();
        outputs();
        for (String option : RUN) {
            if (known.contains(option) && (wanted.equals(option) || dice.chance(.15))) {
                runOptions.add(option);
            }
        }
        if (timed) {
            runOptions.remove("-tf");
        }
        light.keySet().removeIf(option -> !known.contains(option));
        rest.keySet().removeIf(option -> !known.contains(option));
    }

    private boolean is(String option, double probability) {
        return wanted.equals(option) || dice.chance(probability);
    }

    private static String text(double value) {
        return String.format(Locale.ROOT, "%.4g", value);
    }

    private void light(String option, String... values) {
        light.put(option, List.of(values));
    }

    private void rest(String option, String... values) {
        rest.put(option, List.of(values));
    }

    private void reading() throws IOException {
        if (scene.library() != null) {
            if (wanted.equals("--map") || !wanted.equals("--content") && dice.chance(.5)) {
                light("--map", scene.prefix() + "=" + scene.library());
            } else {
                light("--content", scene.library().toString());
            }
        }
        if (is("--frame", .1) || wanted.equals("--frames")) {
            light("--frame", "" + dice.integer(0, 30));
        }
        if (is("--emission", .1)) {
            light("--emission", dice.of("luminosity", "luminosity", "specular"));
        }
        if (is("--lights", .1)) {
            light("--lights", dice.of("auto", "ignore", "emitters"));
        }
        if (is("--srgb", .1)) {
            light("--srgb");
        }
        if (is("--two-sided", .1)) {
            light("--two-sided");
        }
        if (is("--up", .1)) {
            light("--up", dice.of("y", "z"));
        }
        if (is("--photometric", .1)) {
            light("--photometric");
        }
        if (wanted.equals("--leave-out")) {
            spare().ifPresent(name -> light("--leave-out", name));
        }
        if (is("--luminaire", .05)) {
            light("--luminaire", "0," + 99 * scene.size() + ",0=" + upwards());
        }
        if (light.containsKey("--luminaire") || is("--unit", .1)) {
            light("--unit", dice.of("mm", "cm", "m", "in", "ft"));
        }
        if (wanted.equals("--sky") || wanted.equals("--sun")) {
            light("--sky", dice.of("uniform", "cie-overcast", "cie-clear") + "=1e-6"); // adds next to nothing to the rest
            light("--sun", "1,2,3", "1e-6");
        }
        if (scene.kind() != SceneKind.STUDY && is("--strict", .03)) { // there is something to warn of in the study
            light("--strict");
        }
    }

    /** A luminaire that shines to above only: above the scene, it adds no light to it. */
    private Path upwards() throws IOException {
        return Files.writeString(directory.resolve("upwards.ies"),
                "IES:LM-63-2019\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 1\n0 90 180\n0\n0 0 100\n");
    }

    /** The schedule, and what goes with it. */
    private void calculation() {
        boolean mayBeTimed = !light.containsKey("--strict")
                && !Set.of("--accuracy", "--estimates", "-dr", "-si", "-sn", "-tf", "-it", "-se").contains(wanted);
        boolean large = scene.kind() == SceneKind.STUDY;
        timed = mayBeTimed && is("--time", .06) && known.contains("--time");
        schedule = timed || large || wanted.equals("--accuracy") || wanted.equals("--estimates") ? "predict"
                : dice.of("predict", "predict", "predict", "paper", "paper", "shooting", "gathering", "matrix");
        boolean steep = scene.kind() == SceneKind.WHITE || scene.kind() == SceneKind.CLIPPED;
        if (wanted.equals("--schedule") || !schedule.equals("predict") || dice.chance(.2)) {
            light("--schedule", schedule);
        }
        if (timed) {
            light("--time", large ? "2s" : dice.of("200ms", "1s", "2s", "3s"));
        } else if (large || schedule.equals("predict") && is("--accuracy", .97)) {
            light("--accuracy", (large ? dice.of(10, 20) : dice.of(50, 30, 20, 10, 7)) + "%");
        }
        if (!timed && schedule.equals("predict") && known.contains("--estimates") && is("--estimates", .1)) {
            light("--estimates", dice.of("1", "2", "3"));
        }
        if (!timed && !large && (!light.containsKey("--accuracy") || is("-pa", .3))) {
            patchArea();
        }
        boolean predicts = schedule.equals("predict");
        if (!timed && (is("-it", .25) || steep && !predicts)) {
            light("-it", "" + (int) dice.logarithmic(1, 400));
        }
        if (!timed && is("-se", .25)) {
            String unsent = dice.of(".5", "0.1", "0.01", "1e-4", light.containsKey("-it") ? "0" : ".001");
            light("-se", unsent);
        }
        if (predicts && (light.containsKey("-it") || light.containsKey("-se"))) {
            light("--schedule", schedule);
        }
        if (scene.kind() != SceneKind.EMISSION && !large && !schedule.equals("matrix") && is("-mt", .12)) {
            light("-mt", text(dice.logarithmic(1, 30)));
        }
        formFactors();
        if (is("--layers", large ? .5 : .15)) {
            light("--layers");
        }
    }

    /** Hemicubes of few cells are so noisy that meshes are refined at length: shots are few there. */
    private void formFactors() {
        boolean large = scene.kind() == SceneKind.STUDY;
        boolean cells = !timed && dice.chance(.5);
        if (!large && is("--form-factors", .2)) {
            light("--form-factors", cells ? dice.of("hemicube", "nusselt") : dice.of("raycast", "plain"));
            if (cells) {
                light("-it", "" + dice.integer(1, 60));
                light("--schedule", schedule);
                light.computeIfPresent("--accuracy", (option, value) -> List.of("50%"));
            }
        } else {
            cells = false;
        }
        if (!large && (cells || is("-nr", .2))) {
            light("-nr", "" + (int) dice.logarithmic(1, cells ? 20 : 60));
        }
    }

    private void patchArea() {
        double least = schedule.equals("predict") || schedule.equals("paper") ? .5 : 1.5;
        double perCent = dice.logarithmic(least, 20);
        light("-pa", scene.area() > 0 && dice.chance(.3) ? text(perCent / 100 * scene.area()) : text(perCent) + "%");
    }

    private void outputs() throws IOException {
        boolean large = scene.kind() == SceneKind.STUDY;
        if (!timed && !large && is("-si", .1)) {
            rest("-si", "" + dice.integer(1, 50));
        }
        boolean pictures = false;
        if (!timed && !large && is("-sn", .06)) {
            rest("-sn", "" + dice.integer(5, 80));
            pictures = true;
        }
        if (!large && (is("--picture", .1) || wanted.equals("--exposure") || wanted.equals("--tone-mapping")
                || wanted.equals("--size") || wanted.equals("--final-gather"))) {
            rest("--picture", dice.of("picture.png", "picture.jpg", "picture.hdr"));
            pictures = true;
        }
        if (!large && is("--false-colour", .06)) {
            rest("--false-colour", "lux.png");
            pictures = true;
        }
        if (wanted.equals("--final-gather")) {
            rest("--final-gather", "" + dice.integer(1, 40));
        }
        if (pictures) {
            rest("--size", dice.of("40x30", "64x64", "7x90"));
            if (is("--exposure", .3)) {
                rest("--exposure", dice.of("0", "-3", "2.5"));
            }
            if (is("--tone-mapping", .3)) {
                rest("--tone-mapping", dice.of("linear", "reinhard", "filmic"));
            }
        }
        if (is("--points", .12)) {
            rest("--points", points().toString(), "points.csv");
        }
        if (!large && (is("--grid", .06) || wanted.equals("--spacing"))) {
            rest("--grid", surface(), "grid.csv");
            rest("--spacing", text(scene.size() / 8));
        }
        if (is("--report", .15)) {
            rest("--report", "report.json");
        }
        if (!large && is("--lightmap", .06)) {
            rest("--lightmap", "lit.glb");
        }
        if (!large && is("--lightmap-texels", .03)) {
            rest("--lightmap", "lit.glb");
            rest("--lightmap-texels", text(200 / scene.size()));
        }
        if (!large && is("-ut", .06)) {
            rest("-ut", text(24 / scene.size()));
        }
        if (is("-q", .3)) {
            rest("-q");
        }
        if (is("--debug", .05)) {
            rest("--debug");
        }
        if (!timed && is("-dr", .02)) {
            rest("-dr");
        }
    }

    /** Points on the floor, on walls, and where nothing is. */
    private Path points() throws IOException {
        StringBuilder text = new StringBuilder("x,y,z,nx,ny,nz\n");
        double s = scene.size();
        for (int i = 0; i < 20; i++) {
            text.append(String.format(Locale.ROOT, "%s,%s,%s,0,1,0%n", s * dice.between(-.1, 1),
                    dice.of(0.0, 0.0, s / 3), s * dice.between(-1, .1)));
        }
        return Files.writeString(directory.resolve("in.csv"), text);
    }

    private String surface() throws IOException {
        return read().surface(0).name();
    }

    /** The last surface with triangles that does not emit, where there is another one. */
    private Optional<String> spare() throws IOException {
        Scene read = read();
        List<Surface> used = IntStream.range(0, read.triangles()).mapToObj(read::surface).distinct().toList();
        return used.stream().filter(surface -> !surface.emits() && !surface.name().isEmpty()
                        && used.stream().anyMatch(other -> !other.name().equals(surface.name())))
                .map(Surface::name).reduce((first, second) -> second);
    }

    private Scene read() throws IOException {
        ReadOptions options = ReadOptions.defaults();
        return SceneReader.read(scene.file(), scene.library() == null ? options
                : options.withContent(List.of(scene.library())), line -> { });
    }

    /** What the run was made of, for the table. */
    Set<String> used() {
        Set<String> used = new TreeSet<>(light.keySet());
        used.addAll(rest.keySet());
        return used;
    }

    /** The frame that is asked for; empty where there is none. */
    String frame() {
        return light.containsKey("--frame") ? light.get("--frame").get(0) : "";
    }

    boolean has(String option) {
        return light.containsKey(option) || rest.containsKey(option);
    }

    /** Whether accuracy is left to the program: nothing is coarser than it would choose itself. */
    boolean isExact() {
        return schedule.equals("predict") && !light.containsKey("-nr")
                && light.getOrDefault("--form-factors", List.of("raycast")).equals(List.of("raycast"));
    }

    /** Whether prediction goes on to its end, and no clock cuts it off. */
    boolean isFinished() {
        return schedule.equals("predict") && !timed && !light.containsKey("-it")
                && !light.containsKey("-se");
    }

    /** Replaces what decides when to stop, or says how exactly to calculate. */
    List<String> lightWithout(Set<String> options) {
        List<String> words = new ArrayList<>();
        light.forEach((option, values) -> {
            if (!options.contains(option)) {
                words.add(option);
                words.addAll(values);
            }
        });
        return words;
    }

    /** @param directory for what is written */
    List<String> restIn(Path directory, Set<String> without) {
        List<String> words = new ArrayList<>();
        rest.forEach((option, values) -> {
            boolean unused = option.equals("--size") && without.contains("-sn") && !rest.containsKey("--picture");
            if (!without.contains(option) && !unused) {
                words.add(option);
                for (String value : values) {
                    words.add(value.matches("picture\\..*|points.csv|report.json")
                            ? directory.resolve(value).toString() : value);
                }
            }
        });
        return words;
    }
}
