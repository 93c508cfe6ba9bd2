package radiosity.solver;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.input.lightwave.GoldenScenes;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.SurfaceMaps;
import radiosity.output.image.ToneMapping;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;

/**
 * Renders that must give the same light to the last bit wherever and however the program runs, from files to a scene
 * file; small enough for an interpreter. As a program it makes them in a Java virtual machine of its own and prints
 * their hashes.
 */
final class GoldenRenders {

    /** Each in about a tenth of a second, where code is compiled. */
    enum Render {
        IMAGES("images.lws", new RadiositySettings(0.8, 1, Double.POSITIVE_INFINITY, Schedule.PREDICT, 3, 0.2), 40),
        LAYERS("lamps.lws", new RadiositySettings(0.8, 1, Double.POSITIVE_INFINITY, Schedule.PREDICT, 4, 0.5)
                .layers(true), 30),
        PAPER("lamps.lws", new RadiositySettings(0.8, 2, 1, Schedule.PAPER), 60),
        /** Ends by itself, after all that prediction does in the end: here what is lost is given back, too. */
        WHOLE("closed.lws", new RadiositySettings(2, 0, Double.POSITIVE_INFINITY, Schedule.PREDICT, 8, 1),
                Integer.MAX_VALUE);

        private final String file;
        private final RadiositySettings settings;
        private final int shots;

        Render(String file, RadiositySettings settings, int shots) {
            this.file = file;
            this.settings = settings;
            this.shots = shots;
        }
    }

    private GoldenRenders() { }

    /** Prints what {@link #lines} gives for one thread and one part. Arguments: a folder that exists; renders. */
    public static void main(String[] arguments) throws IOException {
        List<Render> renders = Arrays.stream(arguments).skip(1).map(Render::valueOf).toList();
        lines(Path.of(arguments[0]), renders, 1, 1).forEach(System.out::println);
    }

    /**
     * A line for each render and each kind of light: both names, and the hash of the light at all vertices.
     *
     * @param folder  where scenes and scene files are written
     * @param renders which to make
     * @param threads at least 1
     * @param parts   at least 1: partitions that the elements are dealt to
     */
    static List<String> lines(Path folder, List<Render> renders, int threads, int parts) throws IOException {
        GoldenScenes.write(folder);
        List<String> lines = new ArrayList<>();
        for (Render render : renders) {
            Path output = folder.resolve(render.name() + ".scene");
            Solution solution = solve(render, scene(folder.resolve(render.file)), threads, parts);
            SceneFile.write(output, solution, Map.of(), Optional.empty(), ToneMapping.automatic(solution));
            try (SceneFile file = SceneFile.open(output)) {
                lines.addAll(lines(render.name(), file.meshes()));
            }
        }
        return lines;
    }

    private static Scene scene(Path file) throws IOException {
        ReadOptions options = ReadOptions.defaults().withLights(ReadOptions.Lights.EMITTERS);
        return SurfaceMaps.read(LightWaveReader.read(file, options, GoldenRenders::refuse), true,
                GoldenRenders::refuse);
    }

    private static void refuse(String warning) {
        throw new IllegalStateException("expected no warning, got: " + warning);
    }

    private static Solution solve(Render render, Scene scene, int threads, int parts) throws IOException {
        ProgressiveRadiosity rounds = new ProgressiveRadiosity(new LocalWorld(scene, render.settings, threads, parts),
                new StopRule(render.shots, 1e-3));
        rounds.run(progress -> true);
        return rounds.solution();
    }

    private static List<String> lines(String name, List<Mesh> meshes) {
        List<String> lines = new ArrayList<>();
        lines.add(name + " _RADIOSITY " + sha256(meshes.stream().map(Mesh::radiosity).toList()));
        lines.add(name + " _IRRADIANCE " + sha256(meshes.stream().map(Mesh::irradiance).toList()));
        for (int lamp = 0; lamp < meshes.get(0).layers().size(); lamp++) {
            int layer = lamp;
            lines.add(name + " _IRRADIANCE_" + lamp + " "
                    + sha256(meshes.stream().map(mesh -> mesh.layers().get(layer)).toList()));
        }
        return lines;
    }

    private static String sha256(List<float[]> arrays) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            for (float[] array : arrays) {
                ByteBuffer bytes = ByteBuffer.allocate(4 * array.length).order(ByteOrder.LITTLE_ENDIAN);
                bytes.asFloatBuffer().put(array);
                digest.update(bytes);
            }
            return HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }
}
