package radiosity.formfactor;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.mesh.face.Faces;
import radiosity.scene.Light;
import radiosity.scene.Luminaire;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.Rgb;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;
import radiosity.visibility.RadiosityBounds;

/** Light without geometry on a floor that faces up. */
class LightSourcesTest {

    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 FLOOR = new Vec3(0, 0, 0);

    private static Light light(Light.Kind kind, Vec3 direction, Optional<Luminaire> luminaire) {
        return new Light("light", kind, Rgb.grey(2), new Vec3(0, 0, 0), direction, Vec3.ZERO, Vec3.ZERO, 1, 1, .1,
                luminaire);
    }

    /** Irradiance at a place over the middle of the floor, in units of the scene brought to size 1. */
    private static double[] irradiance(Light light, Vec3 place) {
        Faces faces = new Faces(new SceneBuilder()
                .polygon(RoomScenes.grey("floor", 0, .5), new Vec3(-1, 0, -1), new Vec3(-1, 0, 1), new Vec3(1, 0, 1),
                        new Vec3(1, 0, -1))
                .light(light).scene("floor"));
        double[] irradiance = new double[faces.channels()];
        new LightSources(faces, new RadiosityBounds(faces.occluders())).add(place, UP, irradiance, 0, LightSources.SkyRays.EXACT);
        return irradiance;
    }

    @Test
    void lengthOfADirection_doesNotMatter() {
        Vec3 slanted = new Vec3(1, -2, .5);
        Vec3 below = slanted.times(.1);
        Light sun = light(Light.Kind.DISTANT, slanted.unit(), Optional.empty());
        assertArrayEquals(irradiance(sun, FLOOR),
                irradiance(light(Light.Kind.DISTANT, slanted.times(3), Optional.empty()), FLOOR), 1e-12);
        Light spot = light(Light.Kind.SPOT, slanted.unit(), Optional.empty());
        assertArrayEquals(irradiance(spot, below),
                irradiance(light(Light.Kind.SPOT, slanted.times(3), Optional.empty()), below), 1e-12);
    }

    /** A lamp without size at the middle of a ceiling, where a vertex receives. */
    @Test
    void luminaireAtAReceivingPoint_doesNotLightThePoint() {
        LuminousIntensity even = new LuminousIntensity(LuminousIntensity.Type.C, new double[] {0, 360},
                new double[] {0, 180}, new double[] {1, 1, 1, 1});
        Luminaire lamp = new Luminaire(even, new Vec3(1, 0, 0), 0, 0);
        assertArrayEquals(new double[1],
                irradiance(light(Light.Kind.POINT, UP.times(-1), Optional.of(lamp)), FLOOR));
    }
}
