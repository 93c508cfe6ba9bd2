package radiosity.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The names of all units of light come from here. */
class UnitsTest {

    @ParameterizedTest
    @CsvSource({"NaN, false, W/m2 x unit2, W/m2, W/m2, W/m2, W/m2 (Y), irradiance",
        "0.5, false, W, W/m2, W/m2, W/m2, W/m2 (Y), irradiance",
        "NaN, true, lm/m2 x unit2, lm/m2, lx, cd/m2, cd/m2, illuminance",
        "0.5, true, lm, lm/m2, lx, cd/m2, cd/m2, illuminance"})
    void names_followFromLengthAndKindOfLight(double metres, boolean photometric, String flux, String exitance,
            String irradiance, String luminance, String scale, String word) {
        Units units = new Units(metres, photometric);
        assertEquals(flux, units.flux());
        assertEquals(exitance, units.exitance());
        assertEquals(irradiance, units.irradiance());
        assertEquals(luminance, units.luminance());
        assertEquals(scale, units.luminanceScale());
        assertEquals(word, units.irradianceWord());
    }

    /** A white of pi lm/m2 in each channel has a luminance of 1 cd/m2. */
    @Test
    void luminance_isRadiosityByPi_wherePhotometric() {
        Units photometric = new Units(1, true);
        assertEquals(1, photometric.luminance(Rgb.grey(Math.PI)), 1e-15);
        assertEquals(.7152 * 2 / Math.PI, photometric.luminance(new Rgb(0, 2, 0)), 1e-15);
        assertEquals(1 / Math.PI, photometric.luminancePerRadiosity(), 1e-15);
        assertEquals(.7152 * 2, Units.UNKNOWN.luminance(new Rgb(0, 2, 0)), 1e-15);
    }

    @Test
    void flux_isInSquareMetres_andWeightedWherePhotometric() {
        double[] white = {8, 8, 8};
        assertEquals(8 * .25, new Units(.5, false).flux(white), 1e-12, "as of one channel");
        assertEquals(8 * .25, new Units(.5, true).flux(white), 1e-12);
        assertEquals(8 * .25, new Units(.5, true).flux(8), 1e-12);
        assertEquals(8, Units.UNKNOWN.flux(white), 1e-12);
        assertEquals(5, Units.UNKNOWN.flux(1, 5, 9), 1e-12);
    }

    /** The sum over channels of a bound becomes a flux: that of a scene that is nearly grey is nearly a grey scene's. */
    @Test
    void sumOfChannels_isAFluxOfTheColourOfTheLight() {
        assertEquals(2, Units.UNKNOWN.fluxLike(6, new double[] {8, 8, 8}), 1e-12);
        assertEquals(2, Units.UNKNOWN.withPhotometric(true).fluxLike(6, new double[] {8, 8, 8}), 1e-12);
        assertEquals(6 * .7152, Units.UNKNOWN.withPhotometric(true).fluxLike(6, new double[] {0, 1, 0}), 1e-12);
        assertEquals(6, Units.UNKNOWN.fluxLike(6, new double[] {8}), 1e-12);
        assertEquals(6, Units.UNKNOWN.fluxLike(6, new double[] {0}), 1e-12);
    }

    @Test
    void digits_areRaised() {
        assertEquals("lm/m² x unit²", Units.raised("lm/m2 x unit2"));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.POSITIVE_INFINITY})
    void lengthOfAUnit_isAboveZero(double metres) {
        assertThrows(IllegalArgumentException.class, () -> new Units(metres, true));
    }
}
