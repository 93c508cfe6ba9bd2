package radiosity.torture;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A campaign finds what is wrong with a program that was made wrong on purpose; {@link CampaignTest}: and no more. */
@Tag("slow")
@Tag("thorough")
class PlantedFaultsTest {

    /** A fault may miss a run: by its moment, or by options with which it does not count. It does not miss all. */
    private static final int MOST_RUNS = 24;

    @TempDir
    Path directory;

    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();

    private Campaign campaign(PlantedProgram.Plant plant, SceneKind kind, Fault fault, int runs, String expected)
            throws Exception {
        assumeFalse(System.getProperty("os.name").startsWith("Windows"), "has no signals");
        Subject planted = Subject.own().with(PlantedProgram.class.getName(), List.of("-Dplanted=" + plant));
        Campaign campaign = new Campaign(planted, Menu.of(kind, fault), directory,
                new PrintStream(printed, true, StandardCharsets.UTF_8), false);
        campaign.run(21, -1, 1, n -> n < runs && !isFound(campaign, expected));
        return campaign;
    }

    private static boolean isFound(Campaign campaign, String expected) {
        return campaign.failures().stream().anyMatch(line -> line.contains(expected));
    }

    @ParameterizedTest
    @CsvSource({"EXIT_CODE, BLACK, NONE, exit code 7", "NAN, BLACK, NONE, not a number: ",
        "LOST_BLOCK, ROOM, WORKER_KILLED, other light than undisturbed: ",
        "TORN_FILE, ROOM, MASTER_KILLED, torn file: ",
        "ORDER_OF_ARRIVAL, ROOM, NONE, other light than undisturbed: ",
        "GAINED_ENERGY, BLACK, NONE, energy gained: ", "NEGATIVE, BLACK, NONE, negative: "})
    void plantedFault_isFound(PlantedProgram.Plant plant, SceneKind kind, Fault fault, String expected)
            throws Exception {
        Campaign campaign = campaign(plant, kind, fault, MOST_RUNS, expected);
        assertTrue(isFound(campaign, expected), printed::toString);
        assertTrue(printed.toString(StandardCharsets.UTF_8).contains("again: --seed 21."), printed::toString);
    }
}
