package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.Radiosity;
import radiosity.scene.Hierarchy;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;

/**
 * Colours at vertices are factors of the reflectance: rho(p) = rho c(p), c linear between the corners of a triangle. In
 * the mean over a part of a triangle that is rho times the mean of c at the part's corners, as c is linear.
 */
class VertexColoursTest {

    private static final Surface LAMP = new Surface("lamp", Rgb.grey(10), Rgb.BLACK, false);

    /** A lamp over a square floor of 2 triangles. */
    private static Scene room(double reflectance) {
        Surface floor = new Surface("floor", Rgb.BLACK, Rgb.grey(reflectance), false);
        return new SceneBuilder()
                .polygon(floor, new Vec3(0, 0, 0), new Vec3(0, 0, 4), new Vec3(4, 0, 4), new Vec3(4, 0, 0))
                .polygon(LAMP, new Vec3(0, 3, 0), new Vec3(4, 3, 0), new Vec3(4, 3, 4), new Vec3(0, 3, 4)).scene("room");
    }

    /** @param colours 9 for each triangle */
    private static Scene coloured(Scene scene, float[] colours) {
        return new Scene(scene.name(), scene.points(), scene.corners(), scene.surfaceOf(), scene.surfaces(),
                List.of(), Optional.empty(), new float[0], colours, Hierarchy.NONE);
    }

    private static Solution solved(Scene scene) throws IOException {
        return Radiosity.of(scene).settings(new RadiositySettings(1, 4, Double.POSITIVE_INFINITY, Schedule.PAPER))
                .stop(new StopRule(60, 0)).threads(1).run(progress -> true).solution();
    }

    @Test
    void oneColourEverywhere_isThatMuchLessReflectance() throws IOException {
        float[] half = new float[36];
        Arrays.fill(half, .5f);
        Solution expected = solved(room(.4));
        Solution got = solved(coloured(room(.8), half));
        assertEquals(expected.elements(), got.elements());
        for (int e = 0; e < got.elements(); e++) {
            for (int k = 0; k < 3; k++) {
                double b = expected.radiosityAt(e, k).r();
                assertEquals(b, got.radiosityAt(e, k).r(), 1e-6 * b);
            }
        }
    }

    /** Red grows with x: on an element it is that of the element's middle. */
    @Test
    void colours_areLinearOverTheElements() throws IOException {
        Scene scene = room(.8);
        float[] colours = new float[36];
        Arrays.fill(colours, 1);
        for (int corner = 0; corner < 6; corner++) {
            colours[3 * corner] = (float) scene.corner(corner / 3, corner % 3).x() / 4;
        }
        Solution solution = solved(coloured(scene, colours));
        for (int e = 0; e < solution.elements(); e++) {
            if (!solution.surface(e).emits()) {
                double x = 0;
                for (int k = 0; k < 3; k++) {
                    x += solution.positions()[3 * solution.corners()[3 * e + k]] / 3;
                }
                assertEquals(.8 * x / 4, solution.material(e).reflectance().r(), 1e-6);
                assertEquals(.8, solution.material(e).reflectance().g(), 1e-6);
            }
        }
    }
}
