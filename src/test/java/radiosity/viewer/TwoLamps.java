package radiosity.viewer;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;

/** The Cornell box with a second, blue light where the camera is: its lamps kept apart, its light in textures too. */
final class TwoLamps {

    private static final double SAMPLES = 0.2;

    private TwoLamps() { }

    /** @param arguments a folder, in which lamps.scene is written */
    public static void main(String[] arguments) throws IOException {
        write(Path.of(arguments[0]));
    }

    static Path write(Path folder) throws IOException {
        Path file = folder.resolve("lamps.scene");
        Solution solution = solution();
        SceneFile.write(file, solution, Map.of(), solution.scene().camera(), ToneMapping.automatic(solution),
                OptionalDouble.of(SAMPLES));
        return file;
    }

    private static Solution solution() throws IOException {
        Scene box = LightWaveReader.read(Path.of("scenes/cornell-box.lws"), ReadOptions.defaults(), note -> { });
        double range = Math.sqrt(box.area());
        Light blue = new Light("blue", Light.Kind.POINT, new Rgb(0, 0, 2), box.camera().orElseThrow().position(),
                new Vec3(0, 0, -1), Vec3.ZERO, Vec3.ZERO, range, 0, 0);
        Scene lit = new Scene(box.name(), box.points(), box.corners(), box.surfaceOf(), box.surfaces(), List.of(blue),
                box.camera());
        RadiositySettings coarse = new RadiositySettings(box.area() / 200, 1, Double.POSITIVE_INFINITY,
                Schedule.PREDICT, 0.5, 2e-2).layers(true);
        try (LocalWorld world = new LocalWorld(lit, coarse, 2)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, new StopRule(Integer.MAX_VALUE, 0.01));
            rounds.run(progress -> true);
            return rounds.solution();
        }
    }
}
