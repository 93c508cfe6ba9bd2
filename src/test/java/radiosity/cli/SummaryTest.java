package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.cli.render.RenderResult;
import radiosity.cli.render.Summary;
import radiosity.settings.Accuracy;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solution.Certificate;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.RoomScenes;

/** Where less accuracy is reached than was asked for, the summary says so. */
class SummaryTest {

    /** A room with blocks on a mesh that is never refined, however exact it is to be. */
    private static Optional<String> shortfall(double asked) throws IOException {
        RadiositySettings defaults = RadiositySettings.defaults();
        RadiositySettings settings = new RadiositySettings(0, 0, defaults.meshing(), defaults.schedule(),
                Accuracy.tolerance(asked), Double.POSITIVE_INFINITY);
        try (LocalWorld world = new LocalWorld(RoomScenes.withBlocks(RoomScenes.grey("wall", 0, .5),
                RoomScenes.grey("lamp", 1, .5)), settings, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world,
                    new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT));
            radiosity.run(progress -> true);
            RenderResult result = new RenderResult(radiosity.solution(), settings, radiosity.aim(), radiosity.progress(),
                    world.patchArea(), radiosity.certificate(2), Optional.empty(), false, false);
            return new Summary(result, Optional.empty(), 1).shortfall();
        }
    }

    @Test
    void lessThanWasAskedFor_isSaidWithTheSurface() throws IOException {
        String line = shortfall(.01).orElseThrow();
        assertTrue(line.matches("accuracy not reached: expected an error of 1\\.0 %, got \\S+ %; 100 % of it is on wall"), line);
    }

    /** A lampshade is bright: its errors are many W/m², but they count relative to its own light. */
    @Test
    void surfaces_areNamedByTheirShareOfTheError() {
        List<Certificate.SurfaceError> surfaces = List.of(
                new Certificate.SurfaceError("shade", 20, 500, .01, .02, .1),
                new Certificate.SurfaceError("black", 5, 0, 0, 0, 0),
                new Certificate.SurfaceError("floor", 900, .5, .02, .05, .9));
        Certificate found = new Certificate(925, 0.0, 1, 1, 0, .04, .02, .03, 0, 0, surfaces);
        assertEquals("; 90 % of it is on floor, 10 % of it is on shade", Summary.worst(found));
    }

    @Test
    void whatWasAskedFor_isNotMentioned() throws IOException {
        assertEquals(Optional.empty(), shortfall(.5));
    }
}
