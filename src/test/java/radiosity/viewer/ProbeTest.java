package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Rgb;
import radiosity.scene.Surface;
import radiosity.scene.Units;
import radiosity.scene.Vec3;

/** What a click tells of the light, in the units of the scene. */
class ProbeTest {

    private static final Surface WALL = new Surface("wall", new Rgb(1, 2, 3), Rgb.grey(.5), false);

    private static List<String> lines(Units units) {
        return new Probe(WALL, false, new Vec3(1, 2, 3), Rgb.grey(100 * Math.PI), new Rgb(10, 20, 30), Rgb.grey(.5), units)
                .lines();
    }

    @Test
    void photometricScene_isToldInLuxAndCandela() {
        assertEquals(List.of("surface      wall", "radiosity    314.2  314.2  314.2 lm/m²",
                "irradiance   10.00  20.00  30.00 lx", "luminance Y  100.0 cd/m², illuminance 18.60 lx",
                "reflectance  0.5000  0.5000  0.5000", "exitance     1.000  2.000  3.000 lm/m²",
                "at           1.000  2.000  3.000"), lines(new Units(.001, true)));
    }

    @Test
    void radiometricScene_isToldInWatts() {
        assertEquals(List.of("surface      wall", "radiosity    314.2  314.2  314.2 W/m²",
                "irradiance   10.00  20.00  30.00 W/m²", "luminance Y  314.2 W/m², irradiance 18.60 W/m²",
                "reflectance  0.5000  0.5000  0.5000", "exitance     1.000  2.000  3.000 W/m²",
                "at           1.000  2.000  3.000"), lines(Units.UNKNOWN));
    }

    /** The upper end of the scale of false colours: a luminance, in cd/m² where light is photometric. */
    @Test
    void scale_endsAtTheLuminanceThatIsRed() {
        ToneMapping tones = new ToneMapping(ToneMapping.Operator.REINHARD, .01);
        assertEquals(400, TurboColourMap.top(tones, Units.UNKNOWN), 1e-9);
        assertEquals(400 / Math.PI, TurboColourMap.top(tones, new Units(1, true)), 1e-9);
    }
}
