package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.settings.Accuracy;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;
import radiosity.solver.AccuracyLoop.Refine;
import radiosity.testkit.RoomScenes;

/** When the mesh and the rays become finer after points have looked at the solution, and when that ends. */
class AccuracyLoopTest {

    /** For an error of 2 %. */
    private static AccuracyLoop loop() {
        return new AccuracyLoop(new InitialMesh(RoomScenes.cube(RoomScenes.grey("wall", 1, .5)),
                RadiositySettings.defaults()));
    }

    private static Certificate certificate(double expected, double sampling, double meshing) {
        return new Certificate(400, 0.0, 1, 1, 0, expected, sampling, meshing, 0, 0, List.of());
    }

    @Test
    void exactEnough_ends() {
        assertEquals(Refine.NOTHING, loop().refine(certificate(.019, .01, .01), 0, 1000));
    }

    /** A finer mesh tells nothing of openings that the points have not found. */
    @Test
    void uncertaintyOfTheEstimate_isNotAnsweredByRefining() {
        Certificate unsure = new Certificate(400, 0.0, 1, 1, 0, .05, .01, .01, .02, .047, List.of());
        assertEquals(Refine.NOTHING, loop().refine(unsure, 0, 1000));
        Certificate sure = new Certificate(400, 0.0, 1, 1, 0, .05, .01, .04, .02, .02, List.of());
        assertEquals(Refine.MESH, loop().refine(sure, 0, 1000));
    }

    @Test
    void mesh_isRefinedWhereTheErrorIsItsOwn() {
        AccuracyLoop loop = loop();
        double tolerance = loop.tolerance();
        double meshError = loop.meshError();
        assertEquals(Refine.MESH, loop.refine(certificate(.04, .01, .039), 0, 1000));
        assertEquals(tolerance, loop.tolerance());
        assertTrue(loop.meshError() < .5 * meshError, meshError + " became " + loop.meshError());
    }

    /** The next estimate may be larger than the error by chance. */
    @Test
    void meshIsRefined_soThatTheErrorFallsClearlyBelowTheOneAskedFor() {
        AccuracyLoop loop = loop();
        double meshError = loop.meshError();
        assertEquals(Refine.MESH, loop.refine(certificate(.0201, .01, .0174), 0, 1000));
        double rays = .01 * .01;
        assertEquals((.75 * .02 * .02 - rays) / (.0201 * .0201 - rays), loop.meshError() / meshError, 1e-12);
    }

    /** What falls away as marked elements are divided needs no finer mesh elsewhere. */
    @Test
    void mesh_isKeptAsItIsWhereTheErrorIsOnMarkedElements() {
        AccuracyLoop loop = loop();
        double meshError = loop.meshError();
        assertEquals(Refine.MESH, loop.refine(certificate(.04, .01, .039), .95, 1000));
        assertEquals(meshError, loop.meshError());
        assertEquals(Refine.MESH, loop.refine(certificate(.041, .01, .04), .95, 1010));
        assertTrue(loop.meshError() < meshError, "the error has not fallen");
    }

    @Test
    void rays_carryLessWhereTheErrorIsTheirs() {
        AccuracyLoop loop = loop();
        double tolerance = loop.tolerance();
        double meshError = loop.meshError();
        assertEquals(Refine.RAYS, loop.refine(certificate(.04, .039, .01), 0, 1000));
        assertTrue(loop.tolerance() < .7 * tolerance, tolerance + " became " + loop.tolerance());
        assertEquals(meshError, loop.meshError());
    }

    /** Elements divided while rays carry most of the error would all have to gather anew. */
    @Test
    void whatExceedsItsPartMore_isRefinedFirst() {
        assertEquals(Refine.RAYS, loop().refine(certificate(.05, .045, .022), 0, 1000));
        assertEquals(Refine.MESH, loop().refine(certificate(.05, .022, .045), 0, 1000));
    }

    /** What is gathered anew is averaged with what there is: together they are as exact as new vertices. */
    @Test
    void raysAreAdded_notReplaced() {
        AccuracyLoop loop = loop();
        double before = loop.tolerance();
        assertFalse(loop.lacksRays());
        assertEquals(before, loop.toleranceAnew(), 1e-12 * before, "as exact as before halves the variance");
        assertEquals(.5, loop.weightAnew(), 1e-12);
        loop.refine(certificate(.03, .03, .005), 0, 1000);
        assertTrue(loop.lacksRays());
        double old = variance(before);
        double anew = variance(loop.toleranceAnew());
        double weight = loop.weightAnew();
        assertEquals(variance(loop.tolerance()), weight * weight * anew + (1 - weight) * (1 - weight) * old,
                1e-9 * old);
        loop.gatheredAnew();
        assertFalse(loop.lacksRays());
    }

    /** A mesh that is finer than it need be leaves more to the rays; little more light is then to be gathered. */
    @Test
    void rays_mayKeepWhatTheMeshLeaves() {
        AccuracyLoop loop = loop();
        double before = loop.tolerance();
        assertEquals(Refine.RAYS, loop.refine(certificate(.0205, .02, .0045), 0, 1000));
        double mesh = .0205 * .0205 - .02 * .02;
        assertEquals((.75 * .02 * .02 - mesh) / (.02 * .02), variance(loop.tolerance()) / variance(before), 1e-9);
        assertTrue(variance(loop.toleranceAnew()) > 2 * variance(before), "fewer rays than the first sample had");
        assertTrue(loop.weightAnew() < .35, "weight " + loop.weightAnew());
    }

    private static double variance(double tolerance) {
        return Math.pow(Accuracy.of(tolerance), 2);
    }

    @Test
    void moreElementsWithoutProgress_end() {
        AccuracyLoop loop = loop();
        assertEquals(Refine.MESH, loop.refine(certificate(.04, .01, .038), 0, 1000));
        assertEquals(Refine.MESH, loop.refine(certificate(.039, .01, .037), 0, 2000));
        assertEquals(Refine.NOTHING, loop.refine(certificate(.038, .01, .036), 0, 4000));
    }

    /** One look may have met the worst element of all. */
    @Test
    void oneWorseLook_isNotTheEnd() {
        AccuracyLoop loop = loop();
        assertEquals(Refine.MESH, loop.refine(certificate(.2, .01, .2), 0, 1000));
        assertEquals(Refine.MESH, loop.refine(certificate(1, .01, 1), 0, 2000));
        assertEquals(Refine.MESH, loop.refine(certificate(.1, .01, .1), 0, 4000), "better than the first, for the work");
        assertEquals(Refine.MESH, loop.refine(certificate(1, .01, 1), 0, 8000));
        assertEquals(Refine.NOTHING, loop.refine(certificate(1, .01, 1), 0, 16_000));
    }

    /** From 2.88 to 2 % that takes 16 times the elements: affordable, though from 8 to 2 % it would not be. */
    @Test
    void slowProgressNearTheErrorAskedFor_goesOn() {
        AccuracyLoop near = loop();
        assertEquals(Refine.MESH, near.refine(certificate(.0288, .01, .0270), 0, 1000));
        assertEquals(Refine.MESH, near.refine(certificate(.0262, .01, .0242), 0, 2000));
        assertEquals(Refine.MESH, near.refine(certificate(.0239, .01, .0217), 0, 4000));
        assertEquals(Refine.MESH, near.refine(certificate(.0219, .01, .0195), 0, 8000));
        AccuracyLoop far = loop();
        assertEquals(Refine.MESH, far.refine(certificate(.0864, .01, .0858), 0, 1000));
        assertEquals(Refine.MESH, far.refine(certificate(.0786, .01, .0780), 0, 2000));
        assertEquals(Refine.NOTHING, far.refine(certificate(.0717, .01, .0710), 0, 4000));
    }

    /** Nothing was fine enough to be divided: then more has to be, until that is not the cause of the error. */
    @Test
    void sameElements_areDividedMore_untilThatIsEnough() {
        AccuracyLoop loop = loop();
        double meshError = loop.meshError();
        int turns = 0;
        while (loop.refine(certificate(.04, .01, .038), 0, 1000) == Refine.MESH) {
            turns++;
        }
        assertTrue(turns > 3 && turns < 20, turns + " turns");
        assertTrue(loop.meshError() < .01 * meshError);
    }

    @Test
    void smallerAim_goesOnFromWhatThereIs() {
        AccuracyLoop loop = loop();
        Certificate reached = certificate(.019, .005, .018);
        assertEquals(Refine.NOTHING, loop.refine(reached, 0, 1000));
        loop.aim(.01);
        assertEquals(Refine.MESH, loop.refine(reached, 0, 1000));
        assertEquals(.01, loop.asked());
    }
}
