package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.Radiosity;
import radiosity.RadiosityResult;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;

/**
 * Surfaces that lie in the place of others, facing as they do: light arrives there once, and is seen once from
 * everywhere else.
 */
@Tag("slow")
class CoincidentFacesTest {

    private static final Surface WALL = RoomScenes.grey("wall", 0, 0.5);
    private static final Surface LABEL = RoomScenes.grey("label", 0, 0.8);
    private static final Surface LAMP = RoomScenes.grey("lamp", 10, 0.5);
    private static final double LOW = 0.31;
    private static final double HIGH = 0.72;

    /** What lies in the place of a square in the middle of the floor, besides the floor. */
    private enum Kind {
        IN_THE_FLOOR { @Override void add(SceneBuilder room) {
            room.polygon(LABEL, square(0));
        } },
        TWO_MILLIONTHS_ABOVE { @Override void add(SceneBuilder room) {
            room.polygon(LABEL, square(2e-6));
        } },
        EIGHT_MILLIONTHS_ABOVE { @Override void add(SceneBuilder room) {
            room.polygon(LABEL, square(8e-6));
        } },
        THREE_TIMES { @Override void add(SceneBuilder room) {
            room.polygon(LABEL, square(0)).polygon(LABEL, turned()).polygon(WALL, square(0));
        } },
        LAMP_IN_THE_FLOOR { @Override void add(SceneBuilder room) {
            room.polygon(LAMP, square(0));
        } };

        abstract void add(SceneBuilder room);
    }

    private static Vec3[] square(double y) {
        return Stream.of(floor(LOW, LOW, HIGH, HIGH)).map(p -> p.plus(new Vec3(0, y, 0))).toArray(Vec3[]::new);
    }

    /** The square with its corners in another order, so that its diagonal is the other one. */
    private static Vec3[] turned() {
        Vec3[] of = square(0);
        return new Vec3[] {of[1], of[2], of[3], of[0]};
    }

    /** A rectangle of the floor, seen from above. */
    private static Vec3[] floor(double x, double z, double farX, double farZ) {
        return new Vec3[] {new Vec3(x, 0, z), new Vec3(x, 0, farZ), new Vec3(farX, 0, farZ), new Vec3(farX, 0, z)};
    }

    @ParameterizedTest
    @EnumSource
    void lightArrivesOnce(Kind kind) throws IOException {
        boolean isLit = kind == Kind.LAMP_IN_THE_FLOOR;
        SceneBuilder room = walls(isLit).polygon(WALL, floor(0, 0, 1, 1));
        kind.add(room);
        SceneBuilder mosaic = walls(isLit).polygon(WALL, floor(0, 0, LOW, 1)).polygon(WALL, floor(HIGH, 0, 1, 1))
                .polygon(WALL, floor(LOW, 0, HIGH, LOW)).polygon(WALL, floor(LOW, HIGH, HIGH, 1));
        mosaic.polygon(isLit ? LAMP : LABEL, square(0));
        RadiosityResult found = rendered(room);
        EnergyLedger ledger = found.solution().ledger();
        EnergyLedger wanted = rendered(mosaic).solution().ledger();
        assertEquals(wanted.emitted()[0], ledger.emitted()[0], 1e-9);
        assertEquals(wanted.received()[0], ledger.received()[0], 0.005 * wanted.received()[0]);
        Certificate certificate = found.certificate().orElseThrow();
        assertEquals(1, certificate.factors(), 0.01);
        assertEquals(1, certificate.mostFactors(), 0.1);
    }

    /** Four walls and a ceiling, which is a lamp unless the floor has the lamp. */
    private static SceneBuilder walls(boolean isLitFromBelow) {
        SceneBuilder room = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            if (side != 2) {
                room.polygon(side == 3 && !isLitFromBelow ? LAMP : WALL, Box.UNIT.inside(side));
            }
        }
        return room;
    }

    private static RadiosityResult rendered(SceneBuilder room) throws IOException {
        return Radiosity.of(room.scene("room")).accuracy(0.01).run(progress -> true);
    }
}
