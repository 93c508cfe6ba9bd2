package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * Where the light went. Every element keeps received = absorbed + reflected, and reflected + emitted = shot + unshot;
 * summed, with deficit = shot - received, emitted = absorbed + unshot + deficit, whatever the form factors are worth.
 * In a closed room whose surfaces are all visible the deficit is their fault alone.
 */
class EnergyLedgerTest {

    private static final Surface COLOURED =
            new Surface("wall", new Rgb(1, 0.5, 0), new Rgb(0.7, 0.5, 0.3), false);

    @Test
    void energyLedger_closesInEveryRound() throws IOException {
        Scene room = RoomScenes.withBlocks(COLOURED);
        Solve solve = Solve.byDefault().patches(room, 200);
        try (LocalWorld world = new LocalWorld(room, solve.settings(), 1)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, solve.stop());
            rounds.run(progress -> closes(rounds.ledger()));
            assertEquals(0, rounds.ledger().emitted()[2]);
            assertTrue(rounds.ledger().shot()[0] > rounds.ledger().emitted()[0]);
        }
    }

    private static boolean closes(EnergyLedger ledger) {
        for (int c = 0; c < 3; c++) {
            assertEquals(0, ledger.imbalance(c), 1e-12);
        }
        return true;
    }

    @Test
    void emittedFlux_isExitanceTimesArea() {
        Scene room = RoomScenes.withFloatingCube(COLOURED);
        EnergyLedger ledger = Solve.byDefault().patches(room, 1).solution(room).ledger();
        assertEquals(0.5 * room.area(), ledger.emitted()[1], 1e-12 * room.area());
    }

    @ParameterizedTest
    @ValueSource(strings = {"cube", "L-shaped room", "room with blocks", "room with a floating cube", "corridor"})
    void closedRoom_losesNoMoreThanAThousandth(String name) {
        Scene room = RoomScenes.watertight().get(name).apply(RoomScenes.grey("wall", 1, 0.5));
        EnergyLedger ledger = Solve.byDefault().patches(room, 400).solution(room).ledger();
        assertEquals(0, ledger.deficit(0) / ledger.shot()[0], 1e-3);
    }

    /** A block goes through the floor, so that not all that is shot must be received. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({".1, false", ".08, false", ".05, false", ".03, false", ".1, true", ".05, true"})
    void roomWithOverlappingBlock_receivesNoMoreThanWasShot(double error, boolean isBulb) {
        Surface lamp = new Surface("lamp", isBulb ? Rgb.BLACK : new Rgb(1, 2, 3), Rgb.BLACK, false);
        Surface wall = new Surface("wall", Rgb.BLACK, new Rgb(.3, .5, .7), false);
        Box room = new Box(Vec3.ZERO, new Vec3(3, 2, 4));
        Box block = new Box(new Vec3(1, -.2, 1), new Vec3(2, .9, 2.5));
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            builder.polygon(side == 3 ? lamp : wall, room.inside(side));
            Vec3[] inside = block.inside(side);
            builder.polygon(wall, inside[3], inside[2], inside[1], inside[0]);
        }
        if (isBulb) {
            builder.light(new Light("bulb", Light.Kind.POINT, new Rgb(1, 2, 3), new Vec3(1.6, 1.5, 3), Vec3.ZERO,
                    Vec3.ZERO, Vec3.ZERO, 1, 0, 0));
        }
        EnergyLedger ledger = Solve.byDefault().accurate(error).solution(builder.scene("room")).ledger();
        for (int c = 0; c < 3; c++) {
            double gained = -ledger.deficit(c) / ledger.shot()[c];
            assertTrue(gained < 1e-12, "gained " + gained + " of channel " + c);
        }
    }

    /**
     * A lamp in a can in a white room that is open to one side: most light reaches the room after many reflections, so
     * what is left unshot has one sign, and the whole room is too dark by it. What was shot too much is known only when
     * received flux is balanced, after the last shot of a round.
     */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(doubles = {.5, .4, .35, .3, .25, .2, .15, .1})
    void lightOfOneSign_isShotUntilItIsASmallPartOfTheError(double error) {
        Surface lamp = new Surface("lamp", Rgb.grey(1), Rgb.grey(.5), false);
        Surface wall = new Surface("wall", Rgb.BLACK, Rgb.grey(.85), false);
        Box room = new Box(Vec3.ZERO, new Vec3(3, 2, 4));
        Box can = new Box(new Vec3(1, 1.2, 1), new Vec3(1.5, 2, 1.5));
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 5; side++) {
            builder.polygon(wall, room.inside(side));
        }
        for (int side = 0; side < 6; side++) {
            Vec3[] inside = can.inside(side);
            if (side != 2) {
                builder.polygon(side == 3 ? lamp : wall, inside);
                builder.polygon(wall, inside[3], inside[2], inside[1], inside[0]);
            }
        }
        EnergyLedger ledger = Solve.byDefault().accurate(error).solution(builder.scene("room")).ledger();
        double unshot = ledger.unshot()[0] / ledger.emitted()[0];
        assertTrue(Math.abs(unshot) < .1 * error, "unshot " + unshot);
    }
}
