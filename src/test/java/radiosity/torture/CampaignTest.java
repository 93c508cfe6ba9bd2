package radiosity.torture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Some runs of {@code scripts/torture}, and what makes a campaign worth its name. */
@Tag("slow")
class CampaignTest {

    private static final long SEED = 1;
    private static final int RUNS = 6;

    @TempDir
    Path directory;

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no signals")
    void someRuns_findNothing() throws Exception {
        Campaign campaign = new Campaign(Subject.own(), Menu.small(), directory, System.out, false);
        campaign.run(SEED, -1, 2, n -> n < RUNS);
        assertEquals(List.of(), campaign.failures());
    }

    /** An option of the program that no campaign uses is one that nobody tortures. */
    @Test
    void everyOption_isTortured() throws Exception {
        assertEquals(new TreeSet<>(RandomCommand.OPTIONS), new TreeSet<>(Subject.own().options()));
    }

    @Test
    void everyKind_hasItsTurn() {
        Menu menu = Menu.all();
        Set<SceneKind> kinds = new HashSet<>();
        Set<Fault> faults = new HashSet<>();
        Set<String> options = new HashSet<>();
        for (int n = 0; n < 100; n++) {
            kinds.add(Menu.turn(menu.kinds(), SEED, n, 1));
            faults.add(Menu.turn(menu.faults(), SEED, n, 2));
            options.add(Menu.turn(RandomCommand.OPTIONS, SEED, n, 3));
        }
        assertEquals(SceneKind.values().length, kinds.size());
        assertEquals(Fault.values().length, faults.size());
        assertEquals(RandomCommand.OPTIONS.size(), options.size());
    }

    @Test
    void sameSeed_givesTheSameSceneAndCommand() throws Exception {
        for (SceneKind kind : Menu.small().kinds()) {
            List<List<String>> commands = new ArrayList<>();
            List<byte[]> scenes = new ArrayList<>();
            for (String name : List.of("a", "b")) {
                Dice dice = new Dice(5);
                MadeScene scene = kind.make(dice, directory, Path.of("scenes"), false);
                RandomCommand command = new RandomCommand(dice, scene, "-nr", Set.copyOf(RandomCommand.OPTIONS),
                        directory);
                commands.add(command.lightWithout(Set.of()));
                scenes.add(Files.readAllBytes(scene.file()));
                assertTrue(command.has("-nr"), name);
            }
            assertEquals(commands.get(0), commands.get(1));
            assertEquals(0, java.util.Arrays.compare(scenes.get(0), scenes.get(1)), kind.name());
        }
        assertNotEquals(new Dice(1).integer(0, 1 << 30), new Dice(2).integer(0, 1 << 30));
        assertFalse(new Dice(1).chance(0));
    }
}
