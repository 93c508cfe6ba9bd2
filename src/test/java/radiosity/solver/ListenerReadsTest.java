package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.SCENE;
import static radiosity.solver.SameBitsTest.settings;
import static radiosity.solver.SameBitsTest.shots;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.master.RemoteWorld;
import radiosity.master.host.Link;
import radiosity.prediction.GaussSeidel;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.TestLink;

/**
 * A listener only reads: whatever it asks for, wherever it is called, the calculation goes on to the same bits, and so
 * does another one that begins with a state that was saved there.
 */
@Tag("slow")
class ListenerReadsTest {

    private static final StopRule STOP = shots(40);
    /** Longer than a step, so that the listener is called wherever it can be. */
    private static final long TICK = 300_000_000;
    /** One state of this many is gone on from. */
    private static final int SOME = 11;

    private static final Map<Schedule, Solution> UNDISTURBED = new EnumMap<>(Schedule.class);

    /** What a listener may ask for. */
    private interface Question {
        void ask(ProgressiveRadiosity radiosity) throws IOException;
    }

    private enum Reading {
        STATE(ProgressiveRadiosity::state),
        SOLUTION(ProgressiveRadiosity::solution),
        LEDGER(ProgressiveRadiosity::ledger),
        PROGRESS(ProgressiveRadiosity::progress),
        ALL(radiosity -> {
            for (Reading one : values()) {
                if (one.ordinal() < 4) {
                    one.question.ask(radiosity);
                }
            }
        });

        private final Question question;

        Reading(Question question) {
            this.question = question;
        }
    }

    /** Where the elements are. */
    private enum Place {
        HERE, IN_PARTS, ON_HOSTS, ON_HOSTS_THAT_DIE;

        World world(Schedule schedule, LongSupplier clock) throws IOException {
            return switch (this) {
                case HERE -> new LocalWorld(SCENE, settings(schedule), 1, 1, clock);
                case IN_PARTS -> new LocalWorld(SCENE, settings(schedule), 1, 3, clock);
                default -> new RemoteWorld(SCENE, settings(schedule), 1, line -> { }, links(), clock);
            };
        }

        /** The last of three dies in its thirtieth round where one is to die. */
        private List<Link> links() {
            List<Link> links = new ArrayList<>(TestLink.sound(2, 1));
            links.add(new TestLink("igge", 1, round -> this == ON_HOSTS_THAT_DIE && round == 30));
            return links;
        }
    }

    private static LongSupplier clock() {
        AtomicLong now = new AtomicLong();
        return () -> now.addAndGet(TICK);
    }

    private static synchronized Solution undisturbed(Schedule schedule) throws IOException {
        if (!UNDISTURBED.containsKey(schedule)) {
            UNDISTURBED.put(schedule, SameBitsTest.solve(new LocalWorld(SCENE, settings(schedule), 2), STOP));
        }
        return UNDISTURBED.get(schedule);
    }

    static Stream<Arguments> readings() {
        return Arrays.stream(Schedule.values()).flatMap(schedule -> Arrays.stream(Place.values())
                .flatMap(place -> Arrays.stream(Reading.values())
                        .map(reading -> Arguments.of(schedule, place, reading))));
    }

    @ParameterizedTest
    @MethodSource("readings")
    void whateverAListenerAsksFor_changesNothing(Schedule schedule, Place place, Reading reading) throws IOException {
        int[] called = new int[2];
        try (World world = place.world(schedule, clock())) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            radiosity.run(progress -> {
                called[isChoosing() ? 1 : 0]++;
                ask(reading.question, radiosity);
                assertEquals(progress.shots(), radiosity.progress().shots());
                return true;
            });
            ColouredRoom.assertSame(undisturbed(schedule), radiosity.solution());
        }
        assertTrue(called[0] > 1, "called between steps: " + called[0]);
        boolean solves = schedule == Schedule.PREDICT || schedule == Schedule.MATRIX;
        assertEquals(solves, called[1] > 1, "called while who shoots next is chosen: " + called[1]);
    }

    private static void ask(Question question, ProgressiveRadiosity radiosity) {
        try {
            question.ask(radiosity);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Whether the listener is called while the linear system is solved. */
    private static boolean isChoosing() {
        return StackWalker.getInstance().walk(frames -> frames.anyMatch(
                frame -> frame.getClassName().equals(GaussSeidel.class.getName())));
    }

    static Stream<Arguments> places() {
        return Arrays.stream(Schedule.values()).flatMap(schedule -> Stream.of(Place.HERE, Place.ON_HOSTS)
                .map(place -> Arguments.of(schedule, place)));
    }

    @ParameterizedTest
    @MethodSource("places")
    void stateSavedAnywhere_isGoneOnFromToTheSameBits(Schedule schedule, Place place) throws IOException {
        List<SavedState> states = new ArrayList<>();
        try (World world = place.world(schedule, clock())) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            radiosity.run(progress -> {
                ask(one -> states.add(one.state()), radiosity);
                return true;
            });
        }
        for (int s = place.ordinal(); s < states.size(); s += SOME) {
            try (World world = Place.IN_PARTS.world(schedule, clock())) {
                ProgressiveRadiosity rest = new ProgressiveRadiosity(world, STOP);
                rest.resume(states.get(s));
                rest.run(progress -> true);
                ColouredRoom.assertSame(undisturbed(schedule), rest.solution());
            }
        }
    }
}
