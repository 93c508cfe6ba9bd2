package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;
import radiosity.testkit.RoomScenes;

/** When the mesh and the rays become finer after points have looked at the solution, and when that ends. */
class AccuracyLoopTest {

    /** For an error of 2 %. */
    private static AccuracyLoop loop() {
        return new AccuracyLoop(new InitialMesh(RoomScenes.cube(RoomScenes.grey("wall", 1, .5)),
                RadiositySettings.defaults()));
    }

    private static Certificate certificate(double expected, double sampling, double meshing) {
        return new Certificate(400, 0.0, 1, 1, 0, expected, sampling, meshing, 0, List.of());
    }

    @Test
    void exactEnough_ends() {
        assertFalse(loop().goesOn(certificate(.019, .01, .01), 1000));
    }

    @Test
    void mesh_isRefinedWhereTheErrorIsItsOwn() {
        AccuracyLoop loop = loop();
        double tolerance = loop.tolerance();
        double meshError = loop.meshError();
        assertTrue(loop.goesOn(certificate(.04, .01, .039), 1000));
        assertEquals(tolerance, loop.tolerance());
        assertTrue(loop.meshError() < .5 * meshError, meshError + " became " + loop.meshError());
    }

    @Test
    void rays_carryLessWhereTheErrorIsTheirs() {
        AccuracyLoop loop = loop();
        double tolerance = loop.tolerance();
        double meshError = loop.meshError();
        assertTrue(loop.goesOn(certificate(.04, .06, .01), 1000));
        assertTrue(loop.tolerance() < .7 * tolerance, tolerance + " became " + loop.tolerance());
        assertEquals(meshError, loop.meshError());
    }

    @Test
    void moreElementsWithoutProgress_end() {
        AccuracyLoop loop = loop();
        assertTrue(loop.goesOn(certificate(.04, .01, .038), 1000));
        assertTrue(loop.goesOn(certificate(.039, .01, .037), 2000));
        assertFalse(loop.goesOn(certificate(.038, .01, .036), 4000));
    }

    /** One look may have met the worst element of all. */
    @Test
    void oneWorseLook_isNotTheEnd() {
        AccuracyLoop loop = loop();
        assertTrue(loop.goesOn(certificate(.2, .01, .2), 1000));
        assertTrue(loop.goesOn(certificate(1, .01, 1), 2000));
        assertTrue(loop.goesOn(certificate(.1, .01, .1), 4000), "better than the first, for the work");
        assertTrue(loop.goesOn(certificate(1, .01, 1), 8000));
        assertFalse(loop.goesOn(certificate(1, .01, 1), 16_000));
    }

    /** Nothing was fine enough to be divided: then more has to be, until that is not the cause of the error. */
    @Test
    void sameElements_areDividedMore_untilThatIsEnough() {
        AccuracyLoop loop = loop();
        double meshError = loop.meshError();
        int turns = 0;
        while (loop.goesOn(certificate(.04, .01, .038), 1000)) {
            turns++;
        }
        assertTrue(turns > 3 && turns < 20, turns + " turns");
        assertTrue(loop.meshError() < .01 * meshError);
    }

    @Test
    void smallerAim_goesOnFromWhatThereIs() {
        AccuracyLoop loop = loop();
        Certificate reached = certificate(.019, .005, .018);
        assertFalse(loop.goesOn(reached, 1000));
        loop.aim(.01);
        assertTrue(loop.goesOn(reached, 1000));
        assertEquals(.01, loop.asked());
    }
}
