package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.scene.Scene;
import radiosity.settings.Accuracy;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;
import radiosity.solution.RoundListener;
import radiosity.solution.SavedState;
import radiosity.testkit.RoomScenes;

/** A calculation that is done goes on to less error. */
class AimTest {

    private static final Scene ROOM = RoomScenes.withBlocks(RoomScenes.grey("wall", 0, .5),
            RoomScenes.grey("lamp", 1, .5));
    private static final StopRule STOP = new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT);
    private static final RadiositySettings COARSE = RadiositySettings.defaults().accurate(.2);

    /** The error asked for is 2 %, but the calculation begins with a mesh for 50 %. */
    private static final RadiositySettings COARSE_MESH = new RadiositySettings(0, 0, COARSE.meshing(), Schedule.PREDICT,
            Accuracy.tolerance(.02), Accuracy.meshError(.5));

    @Tag("slow")
    @Test
    void smallerError_isReachedFromWhatThereIs() throws IOException {
        try (LocalWorld world = new LocalWorld(ROOM, COARSE, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            radiosity.run(progress -> true);
            int before = radiosity.progress().elements();
            assertEquals(.2, radiosity.aim().getAsDouble(), 1e-12);
            radiosity.aim(.02);
            radiosity.run(progress -> true);
            assertTrue(radiosity.progress().elements() > before);
            assertTrue(radiosity.certificate(2).orElseThrow().expected() <= .02);
        }
    }

    /** The aim is a part of the state. */
    @Test
    @Tag("slow")
    void stoppedOnTheWay_endsWithTheSameBits() throws IOException {
        SavedState whole = state(true, null);
        SavedState part = state(false, null);
        assertNotEquals(whole, part);
        assertEquals(whole, state(true, part));
    }

    private static SavedState state(boolean toTheEnd, SavedState before) throws IOException {
        try (LocalWorld world = new LocalWorld(ROOM, COARSE, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            if (before == null) {
                radiosity.run(progress -> true);
                radiosity.aim(.01);
            } else {
                radiosity.resume(before);
            }
            int elements = radiosity.progress().elements();
            radiosity.run(progress -> toTheEnd || progress.elements() == elements);
            return radiosity.state();
        }
    }

    /** A rule ends a calculation after an estimate; a listener sees the same solution there, and it can go on. */
    @Tag("slow")
    @Test
    void stoppedAfterAnEstimate_isWhatAListenerSees_andGoesOnToTheSameBits() throws IOException {
        Map<Integer, SavedState> seen = new TreeMap<>();
        SavedState whole = estimated(STOP, null, seen);
        assertTrue(seen.size() > 1, "estimates on the way: " + seen.size());
        for (Map.Entry<Integer, SavedState> entry : seen.entrySet()) {
            StopRule rule = new StopRule(Integer.MAX_VALUE, STOP.unsent(), entry.getKey());
            SavedState stopped = estimated(rule, null, new TreeMap<>());
            assertEquals(entry.getValue(), stopped, "after " + entry.getKey() + " estimates");
            assertEquals(whole, estimated(STOP, stopped, new TreeMap<>()));
        }
    }

    /** @param seen receives the states after estimates on the way, by the number of estimates */
    private static SavedState estimated(StopRule stop, SavedState before, Map<Integer, SavedState> seen)
            throws IOException {
        try (LocalWorld world = new LocalWorld(ROOM, COARSE_MESH, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, stop);
            if (before != null) {
                radiosity.resume(before);
            }
            radiosity.run(new RoundListener() {
                @Override
                public boolean afterRound(Progress progress) {
                    return true;
                }

                @Override
                public boolean afterEstimate(Progress progress) throws IOException {
                    seen.put(radiosity.estimates(), radiosity.state());
                    return true;
                }
            });
            return radiosity.state();
        }
    }

    @Test
    void resumedToLeaveLess_goesOn() throws IOException {
        try (LocalWorld world = new LocalWorld(ROOM, COARSE, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, new StopRule(Integer.MAX_VALUE, 1e-4));
            radiosity.resume(finished());
            double before = radiosity.progress().unsent();
            radiosity.run(progress -> true);
            double after = radiosity.progress().unsent();
            assertTrue(before > 1e-4 && after <= 2e-4, "unsent " + before + ", then " + after);
        }
    }

    /** The unshot flux that is left may exceed what the last estimate, which is lower than those before, would allow. */
    @Tag("slow")
    @Test
    void resumedAfterTheEnd_isLeftAsItIs() throws IOException {
        SavedState before = null;
        for (double error : new double[] {.2, .05, .02, .01}) {
            SavedState end = run(before, error, progress -> true);
            assertEquals(end, run(end, error, progress -> fail("goes on at " + error)));
            before = end;
        }
    }

    private static SavedState run(SavedState before, double error, RoundListener listener) throws IOException {
        try (LocalWorld world = new LocalWorld(ROOM, COARSE, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            if (before != null) {
                radiosity.resume(before);
            }
            radiosity.aim(error);
            radiosity.run(listener);
            return radiosity.state();
        }
    }

    private static SavedState finished() throws IOException {
        try (LocalWorld world = new LocalWorld(ROOM, COARSE, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            radiosity.run(progress -> true);
            return radiosity.state();
        }
    }

    @Test
    void otherSchedules_lookAtNoError() throws IOException {
        RadiositySettings paper = new RadiositySettings(0, 0, COARSE.meshing(), Schedule.PAPER);
        try (LocalWorld world = new LocalWorld(ROOM, paper, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            radiosity.aim(.01);
            assertEquals(OptionalDouble.empty(), radiosity.aim());
            assertThrows(IllegalArgumentException.class, () -> radiosity.aim(0));
        }
    }
}
