package radiosity.scene;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A light checks itself. */
class LightTest {

    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    private static Light spot(double power, double x, Vec3 direction, double range, double cone, double edge) {
        return new Light("spot", Light.Kind.SPOT, new Rgb(1, power, 1), new Vec3(x, 0, 0), direction, Vec3.ZERO,
                Vec3.ZERO,
                range, cone, edge);
    }

    private static void assertRefused(double power, double x, Vec3 direction, double range, double cone, double edge) {
        String message = assertThrows(IllegalArgumentException.class,
                () -> spot(power, x, direction, range, cone, edge))
                .getMessage();
        assertTrue(message.startsWith("light spot: expected "), message);
        assertTrue(message.contains(", got "), message);
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, -1e-9})
    void valueThatIsNone_isRefusedInOneLine(double wrong) {
        assertRefused(wrong, 0, DOWN, 1, 1, .1);
        assertRefused(1, 0, DOWN, wrong, 1, .1);
        assertRefused(1, 0, DOWN, 1, wrong, .1);
        assertRefused(1, 0, DOWN, 1, 1, wrong);
    }

    @Test
    void placeAndDirection_areNumbers() {
        assertRefused(1, Double.NaN, DOWN, 1, 1, .1);
        assertRefused(1, 0, Vec3.ZERO, 1, 1, .1);
        assertRefused(1, 0, new Vec3(0, Double.NEGATIVE_INFINITY, 0), 1, 1, .1);
        assertRefused(1, 0, DOWN, 1, 4, .1);
        assertRefused(1, 0, DOWN, 0, 1, .1);
    }

    @Test
    void whatAKindDoesNotUse_mayBeZero() {
        assertDoesNotThrow(() -> new Light("p", Light.Kind.POINT, Rgb.grey(1), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO,
                Vec3.ZERO, 1,
                0, 0));
        assertDoesNotThrow(() -> new Light("d", Light.Kind.DISTANT, Rgb.grey(1), Vec3.ZERO, DOWN, Vec3.ZERO, Vec3.ZERO,
                0, 0,
                0));
    }
}
