package radiosity.output.raytrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.scene.Vec3;

/** Fresnel's equations and Snell's law against their closed forms. */
class FresnelTest {

    private static final Vec3 UP = new Vec3(0, 1, 0);

    /** Comes down at an angle to the vertical. */
    private static Vec3 down(double angle) {
        return new Vec3(Math.sin(angle), -Math.cos(angle), 0);
    }

    @ParameterizedTest
    @CsvSource({"1.5, 0.04", "2, 0.1111111111111111", "0.5, 0.1111111111111111", "1, 0"})
    void atRightAngles_theIndexDecides(double index, double expected) {
        assertEquals(expected, Fresnel.reflectance(1, index), 1e-12);
        assertEquals(0, Fresnel.rise(1, index), 1e-12);
    }

    /** At tan = n nothing is reflected of one polarisation: of the other ((n2 - 1) / (n2 + 1))2, of both half of it. */
    @ParameterizedTest
    @CsvSource({"1.5", "1.33", "2.4", "0.75"})
    void atBrewstersAngle_onePolarisationIsNotReflected(double index) {
        double other = (index * index - 1) / (index * index + 1);
        assertEquals(other * other / 2, Fresnel.reflectance(Math.cos(Math.atan(index)), index), 1e-12);
    }

    /** R(theta) by sines and tangents of both angles: (sin2(i - t) / sin2(i + t) + tan2(i - t) / tan2(i + t)) / 2. */
    @ParameterizedTest
    @CsvSource({"1.5, 10", "1.5, 45", "1.5, 80", "1.33, 60", "0.6666666666666666, 30"})
    void anyAngle_isAsInTheFormOfSinesAndTangents(double index, double degrees) {
        double i = Math.toRadians(degrees);
        double t = Math.asin(Math.sin(i) / index);
        double sines = Math.sin(i - t) / Math.sin(i + t);
        double tangents = Math.tan(i - t) / Math.tan(i + t);
        double expected = (sines * sines + tangents * tangents) / 2;
        assertEquals(expected, Fresnel.reflectance(Math.cos(i), index), 1e-12);
        assertEquals(expected, Fresnel.reflectance(Math.cos(t), 1 / index), 1e-12, "the same way back");
        double normal = Fresnel.reflectance(1, index);
        assertEquals(expected, normal + (1 - normal) * Fresnel.rise(Math.cos(i), index), 1e-12);
    }

    @ParameterizedTest
    @CsvSource({"1.5, 0", "1.5, 30", "1.5, 89", "0.75, 45", "1, 20"})
    void refractedRay_hasSnellsAngle_andStaysInItsPlane(double index, double degrees) {
        Vec3 d = down(Math.toRadians(degrees));
        Vec3 t = Fresnel.refracted(d, UP, index);
        assertEquals(Math.sin(Math.toRadians(degrees)) / index, t.x(), 1e-12);
        assertEquals(0, t.z(), 1e-12);
        assertEquals(1, t.length(), 1e-12);
        assertEquals(0, Fresnel.refracted(t, UP, 1 / index).minus(d).length(), 1e-12, "the same way back");
    }

    @Test
    void beyondTheCriticalAngle_allIsReflected() {
        double critical = Math.asin(1 / 1.5);
        assertNull(Fresnel.refracted(down(critical + 1e-6), UP, 1 / 1.5));
        assertEquals(1, Fresnel.reflectance(Math.cos(critical + 1e-6), 1 / 1.5));
        assertEquals(1, Fresnel.reflectance(0, 1.5));
        assertEquals(0, Fresnel.mirrored(down(.3), UP).minus(new Vec3(Math.sin(.3), Math.cos(.3), 0)).length(), 1e-12);
    }
}
