package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.options.CommandLineParser;
import radiosity.cli.options.RendererOptions;
import radiosity.cli.render.SaveBeforeExit;
import radiosity.cli.render.SavedCalculation;
import radiosity.cli.terminal.StopRequest;
import radiosity.solution.SavedState;
import radiosity.testkit.ProgramRun;

/** The frames of a scene in which a block moves by 20 mm in a second of 25 frames. */
@Tag("slow")
class AnimationTest {

    private static final String STILL = "{ Envelope\n  1\n  Key 0 0 3 0 0 0 0 0 0\n  Behaviors 1 1\n}\n";
    private static final String MOVES = "{ Envelope\n  2\n  Key 0 0 3 0 0 0 0 0 0\n  Key 20 1 3 0 0 0 0 0 0\n"
            + "  Behaviors 1 1\n}\n";

    @TempDir
    Path directory;
    private Path scene;

    @BeforeEach
    void makeScene() throws IOException {
        String text = Files.readString(Path.of("scenes/cornell-box.lws"));
        int second = text.indexOf("LoadObjectLayer 2");
        String moving = text.substring(0, second) + text.substring(second).replaceFirst(
                java.util.regex.Pattern.quote(STILL), MOVES);
        assertNotEquals(text, moving);
        scene = directory.resolve("moving.lws");
        Files.writeString(scene, moving);
        Files.copy(Path.of("scenes/cornell-box.lwo"), directory.resolve("cornell-box.lwo"));
    }

    private ProgramRun render() {
        ProgramRun run = ProgramRun.of("-q", "--accuracy", "30%", "--frames", "0-20:10", "--report",
                directory.resolve("a.json"), scene, directory.resolve("a.scene"));
        assertTrue(List.of(0, 5).contains(run.exitCode()), run.err());
        return run;
    }

    private SavedState state(int frame) throws IOException {
        return SavedCalculation.read(file(frame)).state();
    }

    private Path file(int frame) {
        return directory.resolve(String.format("a-%04d.scene", frame));
    }

    @Test
    void frames_areMadeOnceAndGoOnWhereTheyWereStopped() throws IOException {
        ProgramRun first = render();
        assertTrue(first.err().contains("frame 10 (2 of 3)"), first.err());
        assertTrue(Files.exists(directory.resolve("a-0020.json")));
        assertNotEquals(state(0), state(10));
        SavedState last = state(20);
        assertTrue(!render().err().contains("frame "), "nothing is done twice");
        Files.delete(file(20));
        ProgramRun rest = render();
        assertTrue(rest.err().contains("frame 20 (3 of 3)") && !rest.err().contains("frame 10"), rest.err());
        assertTrue(rest.err().contains("2 of 3 frames were there, newer than"), rest.err());
        assertEquals(last, state(20));
        Files.delete(directory.resolve("a-0010.json"));
        rest = render();
        assertTrue(rest.err().contains("frame 10 (2 of 3)"), "a frame without its report is not done: " + rest.err());
        assertTrue(Files.exists(directory.resolve("a-0010.json")));
    }

    /** The first frame stops after a round; writing its pictures forgets the request, which it has fulfilled. */
    @Test
    void stopDuringAFrame_leavesOutTheFramesAfterIt() throws IOException {
        StopRequest stop = new StopRequest();
        List<String> arguments = List.of("-q", "--frames", "0-20:10", "-pa", "5000", scene.toString(),
                directory.resolve("a.scene").toString());
        try (SaveBeforeExit ending = new SaveBeforeExit(stop, Duration.ZERO)) {
            animate(arguments, stop, frame -> {
                stop.make();
                new RadiosityRenderer(frame, arguments, stop).render(ending);
            });
        }
        assertTrue(Files.exists(file(0)));
        assertFalse(Files.exists(file(10)));
    }

    @Test
    void stopDuringALaterFrame_isAnsweredAsInTheFirst() throws IOException {
        List<String> answers = new ArrayList<>();
        for (int last : new int[] {0, 10}) {
            StopRequest stop = new StopRequest();
            stop.tell(answers::add);
            animate(List.of("--frames", "0-20:10", "a.lws", file(0).toString()), stop, frame -> {
                if (frame.output().toString().endsWith(String.format("%04d.scene", last))) {
                    stop.make();
                }
                stop.renew("leaving out the pictures that are not finished");
            });
        }
        String answer = "stopping after this round, then saving";
        assertEquals(List.of(answer, answer), answers);
    }

    private static void animate(List<String> arguments, StopRequest stop, Animation.Renderer renderer)
            throws IOException {
        RendererOptions options = new RendererOptions();
        new CommandLineParser(options).parse(arguments.toArray(String[]::new));
        new Animation(arguments, stop, renderer).render(options);
    }

    @Test
    void otherOptions_areRefused() {
        assertEquals(2, ProgramRun.of("--frames", "0-2", "--time", "1s", scene, file(0)).exitCode());
        assertEquals(2, ProgramRun.of("--frames", "2-0", scene, file(0)).exitCode());
        assertEquals(2, ProgramRun.of("--frames", "0-2", "--change", file(0), "-tf", file(0), scene, file(1))
                .exitCode());
    }
}
