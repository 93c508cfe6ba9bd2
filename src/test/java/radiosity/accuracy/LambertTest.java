package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import radiosity.scene.Vec3;

/**
 * The contour sum against closed forms that need none; J. R. Howell, A Catalog of Radiation Configuration Factors,
 * 1982.
 */
class LambertTest {

    private static final Vec3[] SQUARE = {new Vec3(-1, -1, 0), new Vec3(1, -1, 0), new Vec3(1, 1, 0),
            new Vec3(-1, 1, 0)};

    /** Howell B-4: a point over the corner of an a x b rectangle at distance c, taken four times. */
    @Test
    void pointOverTheCentreOfASquare_hasTheCatalogValue() {
        double a = 1 / Math.sqrt(1 + 1);
        double corner = 2 * a * Math.atan(a) / (2 * Math.PI);
        assertEquals(4 * corner, Lambert.factor(new Vec3(0, 0, 1), new Vec3(0, 0, -5), SQUARE), 1e-15);
    }

    @Test
    void uprightPointBesideALargePlane_seesHalf() {
        Vec3[] plane = {new Vec3(-1e6, -1e6, 0), new Vec3(1e6, -1e6, 0), new Vec3(1e6, 1e6, 0), new Vec3(-1e6, 1e6, 0)};
        assertEquals(0.5, Lambert.factor(new Vec3(0, 0, 1), new Vec3(1, 0, 0), plane), 1e-6);
    }

    @Test
    void pointThatLooksAway_seesNothing() {
        assertEquals(0, Lambert.factor(new Vec3(0, 0, 1), new Vec3(0, 0, 1), SQUARE));
    }
}
