package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.Solution;
import radiosity.testkit.Box;
import radiosity.testkit.Cells;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * What enters a room through an opening of area A in its roof: E A of a sky that gives the open E, and E A cos of a sun
 * at an angle to the zenith. Only the inner sides of the walls are there. The ledger says that, whatever the first mesh
 * makes of a patch of sunlight that is smaller than its elements.
 */
@Tag("slow")
class DaylightLedgerTest {

    private static final Surface WALL = RoomScenes.grey("wall", 0, .5);
    private static final Surface OPEN = RoomScenes.grey("opening", 0, 0);
    private static final Vec3 UP = new Vec3(0, 0, 1);

    private static EnergyLedger ledger(Light... lights) {
        double[] x = {0, 1.8, 2.2, 4};
        Scene room = CiePhotometryTest.without(OPEN, new Cells(x, x, new double[] {0, 3}).room("roof", (i, j, k) -> true,
                (i, j, k, face) -> face == 5 && i == 1 && j == 1 ? OPEN : WALL));
        return Solve.byDefault().accurate(.2).solution(room.with(room.surfaces(), List.of(lights))).ledger();
    }

    private static void assertEnters(double flux, EnergyLedger ledger) {
        assertEquals(flux, ledger.emitted()[0], .01 * flux);
        double found = ledger.absorbed()[0] + ledger.unshot()[0] + ledger.escaped()[0];
        assertTrue(Math.abs(found - flux) < .1 * flux, found + " W of " + flux);
        assertEquals(0, ledger.imbalance(0), 1e-12);
    }

    @Test
    void skyThroughAnOpening_isWhatIsEmitted() {
        assertEnters(100 * .16, ledger(Light.sky(Light.Kind.SKY_OVERCAST, 100, UP, UP)));
    }

    /** A ray that passes between two walls by rounding stands for more light than the lamp. */
    @Test
    void skyAroundAClosedRoom_entersNowhere() {
        SceneBuilder builder = new SceneBuilder();
        RoomScenes.addRoom(builder, WALL, new Box(Vec3.ZERO, new Vec3(4, 2.5, 5)));
        Scene room = builder.polygon(RoomScenes.grey("lamp", 1, 0), new Vec3(.8, 2.48, 1), new Vec3(1.2, 2.48, 1),
                new Vec3(1.2, 2.48, 1.4), new Vec3(.8, 2.48, 1.4)).scene("closed room");
        Solution solution = Solve.byDefault().accurate(.2).solution(room.with(room.surfaces(),
                List.of(Light.sky(Light.Kind.SKY_UNIFORM, 1e6, UP, UP), Light.sun(new Vec3(1, 2, 2), 1e6))));
        assertEquals(.16, solution.ledger().emitted()[0], 1e-6);
        assertEquals(0, solution.ledger().imbalance(0), 1e-12);
    }

    @Test
    void sunThroughAnOpening_isWhatIsEmitted() {
        assertEnters(100 * .16 * 2 / 3, ledger(Light.sun(new Vec3(1, 2, 2), 100)));
    }

    /** Bars thinner than what a few rays see hide their share: no more arrives than enters. */
    @Test
    void skyThroughBars_isNoMoreThanWhatEnters() {
        SceneBuilder builder = new SceneBuilder();
        builder.polygon(RoomScenes.grey("ground", 0, .2), new Vec3(-1, -1, 0), new Vec3(5, -1, 0), new Vec3(5, 5, 0),
                new Vec3(-1, 5, 0));
        for (int i = 0; i < 12; i++) {
            double at = .05 + .35 * i;
            RoomScenes.addSolid(builder, WALL, new Vec3(at, 0, 1.5), new Vec3(at + .04, 4, 1.54));
            RoomScenes.addSolid(builder, WALL, new Vec3(0, at, 1.6), new Vec3(4, at + .04, 1.64));
        }
        Scene pergola = builder.scene("pergola");
        EnergyLedger ledger = Solve.byDefault().accurate(.05).solution(pergola.with(pergola.surfaces(),
                List.of(Light.sky(Light.Kind.SKY_UNIFORM, 100, UP, UP)))).ledger();
        double found = ledger.absorbed()[0] + ledger.unshot()[0] + ledger.escaped()[0];
        assertEquals(1, found / ledger.emitted()[0], .004);
    }
}
