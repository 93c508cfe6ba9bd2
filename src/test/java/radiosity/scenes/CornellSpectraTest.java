package radiosity.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** The expected values are means of the published tables, computed apart from the program. */
class CornellSpectraTest {

    @Test
    void channels_areTheMeansOfThirdsOfTheRange() {
        double[] rising = {0, 1, 2, 3, 4, 5, 6};
        assertEquals(1, CornellSpectra.third(rising, 0));
        assertEquals(3, CornellSpectra.third(rising, 1));
        assertEquals(5, CornellSpectra.third(rising, 2));
    }

    @Test
    void light_isTheWellKnown17_12_4() {
        Material light = CornellSpectra.light();
        assertEquals(17, light.luminosity() * light.red() / Math.PI, 1e-12);
        assertEquals(11.8, light.luminosity() * light.green() / Math.PI, 1e-12);
        assertEquals(4, light.luminosity() * light.blue() / Math.PI, 1e-12);
    }

    @Test
    void paints_areRedAndGreenAndNearlyWhite() {
        assertPaint(CornellSpectra.white(), .734, .736, .706);
        assertPaint(CornellSpectra.green(), .132, .348, .117);
        assertPaint(CornellSpectra.red(), .581, .088, .057);
    }

    private static void assertPaint(Material paint, double red, double green, double blue) {
        assertEquals(red, paint.diffuse() * paint.red(), 5e-4);
        assertEquals(green, paint.diffuse() * paint.green(), 5e-4);
        assertEquals(blue, paint.diffuse() * paint.blue(), 5e-4);
    }
}
