package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * A lamp in a white tube of many small faces: faces that are small against the room are lit at one point only, but not
 * where they are so bright that the light of the room hangs on them. A lit tube whose faces are even from the lamp to
 * the rim gives the room a sixth more light than the lamp emits.
 */
@Tag("slow")
class SmallBrightFacesTest {

    private static final int FACETS = 36;
    private static final double RADIUS = .06;
    private static final double TOP = 2.99;
    private static final double RIM = 2.9;

    /** @param lampRadius the lamp is level, and lower than the tube's upper end where it is smaller */
    private static Scene downlight(double lampRadius) {
        double part = lampRadius / RADIUS;
        double height = part < 1 ? TOP - .005 : TOP;
        SceneBuilder builder = new SceneBuilder();
        Surface wall = RoomScenes.grey("wall", 0, .8);
        Box room = new Box(Vec3.ZERO, new Vec3(3, 3, 3));
        for (int side = 0; side < 6; side++) {
            builder.polygon(wall, room.inside(side));
        }
        Surface tube = new Surface("tube", Rgb.BLACK, Rgb.grey(.82), true);
        Surface lamp = RoomScenes.grey("lamp", 4000, .5);
        for (int i = 0; i < FACETS; i++) {
            builder.polygon(tube, at(i, TOP), at(i, RIM), at(i + 1, RIM), at(i + 1, TOP));
            builder.polygon(lamp, new Vec3(1.5, height, 1.5), at(i, part, height), at(i + 1, part, height));
            if (part < 1) {
                builder.polygon(tube, new Vec3(1.5, TOP, 1.5), at(i, TOP), at(i + 1, TOP));
            }
        }
        return builder.scene("downlight");
    }

    /** On the rim, counted around it. */
    private static Vec3 at(int i, double y) {
        return at(i, 1, y);
    }

    private static Vec3 at(int i, double part, double y) {
        double angle = 2 * Math.PI * (i % FACETS) / FACETS;
        return new Vec3(1.5 + part * RADIUS * Math.cos(angle), y, 1.5 + part * RADIUS * Math.sin(angle));
    }

    private static double sum(double[] channels) {
        double sum = 0;
        for (double channel : channels) {
            sum += channel;
        }
        return sum;
    }

    @Test
    void lampInATube_absorbsWhatIsEmitted() throws Exception {
        EnergyLedger ledger = Solve.byDefault().solution(downlight(RADIUS)).ledger();
        double emitted = sum(ledger.emitted());
        double absorbed = sum(ledger.absorbed());
        assertTrue(Math.abs(absorbed - emitted) < .02 * emitted, "emitted " + emitted + " W, absorbed " + absorbed);
    }

    /**
     * The tube's light falls steeply beside the lamp: its middle is less than the mean of its corners everywhere, and all
     * of these have too much together.
     */
    @Test
    void lampBelowTheEndOfATube_addsHalfOfTheErrorAskedForAtMost() throws Exception {
        EnergyLedger ledger = Solve.byDefault().accurate(.1).solution(downlight(.4 * RADIUS)).ledger();
        double emitted = sum(ledger.emitted());
        double absorbed = sum(ledger.absorbed());
        assertTrue(absorbed < 1.05 * emitted, "emitted " + emitted + " W, absorbed " + absorbed);
    }
}
