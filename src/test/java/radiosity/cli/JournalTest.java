package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.cli.render.Journal;
import radiosity.cli.render.JournalClaim;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.ColouredRoom;

/** A journal follows its clock, and changes nothing. */
class JournalTest {

    private static final Scene SCENE = ColouredRoom.SCENE;
    private static final StopRule STOP = new StopRule(40, 1e-3);
    /** Longer than any journal's interval before the first one was written. */
    private static final long HOUR = 3_600_000_000_000L;
    /** One journal of this many is gone on from. */
    private static final int SOME = 7;

    @TempDir
    Path directory;

    private JournalClaim claim;

    private static RadiositySettings settings(Schedule schedule) {
        return new RadiositySettings(SCENE.area() / 120, 1, Double.POSITIVE_INFINITY, schedule, 0.3, 2e-3);
    }

    private static ProgressiveRadiosity radiosity(Schedule schedule) {
        return new ProgressiveRadiosity(new LocalWorld(SCENE, settings(schedule), 1), STOP);
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource(Schedule.class)
    void journalAtEveryCall_changesNothingAndIsGoneOnFromToTheSameBits(Schedule schedule) throws IOException {
        ProgressiveRadiosity undisturbed = radiosity(schedule);
        undisturbed.run(progress -> true);
        Solution expected = undisturbed.solution();

        List<byte[]> journals = new ArrayList<>();
        // between two looks of one call nothing passes, so that writing costs nothing by this clock
        AtomicLong clock = new AtomicLong();
        Journal journal = new Journal(claim(), settings(schedule).toString(), line -> { }, clock::get);
        ProgressiveRadiosity watched = radiosity(schedule);
        watched.run(progress -> {
            clock.addAndGet(HOUR);
            journals.add(kept(journal, watched));
            return true;
        });
        ColouredRoom.assertSame(expected, watched.solution());

        for (int j = 0; j < journals.size(); j += SOME) {
            Files.write(file(), journals.get(j));
            ProgressiveRadiosity rest = radiosity(schedule);
            assertTrue(journal.resume(rest));
            rest.run(progress -> true);
            ColouredRoom.assertSame(expected, rest.solution());
        }
    }

    @ParameterizedTest
    @EnumSource(value = Schedule.class, names = "PAPER")
    void clockThatStands_writesNoJournal(Schedule schedule) throws IOException {
        Journal journal = new Journal(claim(), settings(schedule).toString(), line -> { }, () -> 0);
        ProgressiveRadiosity watched = radiosity(schedule);
        watched.run(progress -> {
            assertEquals(0, kept(journal, watched).length);
            return true;
        });
    }

    @Test
    void stateThatDoesNotFitIntoMemory_isAWarningAndNoMore() throws IOException {
        List<String> notices = new ArrayList<>();
        Journal journal = new Journal(claim(), RadiositySettings.defaults().toString(), notices::add, () -> 0);
        Journal.Source tooLarge = () -> {
            throw new OutOfMemoryError("Java heap space");
        };
        journal.keepNow(tooLarge);
        journal.keepNow(tooLarge);
        assertEquals(1, notices.size(), notices.toString());
        assertTrue(notices.get(0).startsWith("warning: " + file() + ": expected to be written, got memory: "),
                notices.toString());
        journal.keepNow(() -> SavedState.of(List.of(new byte[10])));
        assertTrue(Files.exists(file()));
    }

    @Test
    void resultThatCannotBeWritten_isKeptInTheJournal_ifThatCanBeWritten() throws IOException {
        Journal journal = new Journal(claim(), RadiositySettings.defaults().toString(), line -> { }, () -> 0);
        SavedState state = SavedState.of(List.of(new byte[10]));
        Path obstacle = Files.createDirectories(file().resolve("obstacle"));
        assertEquals("nothing was kept", journal.keepResult(state));
        Files.delete(obstacle);
        Files.delete(file());
        assertEquals("the same command goes on from " + file(), journal.keepResult(state));
    }

    @AfterEach
    void endClaim() throws IOException {
        claim.close();
    }

    private JournalClaim claim() throws IOException {
        claim = JournalClaim.of(file());
        return claim;
    }

    private Path file() {
        return directory.resolve("foobar.scene.journal");
    }

    /** What the journal holds then; nothing where there is none. */
    private byte[] kept(Journal journal, ProgressiveRadiosity radiosity) {
        try {
            journal.keep(radiosity::state);
            return Files.exists(file()) ? Files.readAllBytes(file()) : new byte[0];
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
