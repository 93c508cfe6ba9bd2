package radiosity.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.visibility.RadiosityBounds;

@Tag("slow")
class StudyTest {

    private static Scene study;
    private static SceneFaces faces;

    @BeforeAll
    static void read() throws IOException {
        study = ShippedScenes.read("study.lws");
        faces = new SceneFaces(study, 2e-5);
    }

    @Test
    void everySolid_isClosedByItselfOrByWhatItStandsOn() {
        assertEquals(List.of(), faces.openEdges());
    }

    @Test
    void noTwoFaces_lieOnEachOther() {
        assertEquals(List.of(), faces.coincidentFaces());
    }

    @Test
    void noTwoSolids_goThroughEachOther() {
        assertEquals(List.of(), faces.crossings());
    }

    @Test
    void paints_areAsDarkAndAsBrightAsRealOnes() {
        for (Surface surface : study.surfaces()) {
            Rgb paint = surface.reflectance();
            double mean = (paint.r() + paint.g() + paint.b()) / 3;
            assertTrue(mean >= .04 && paint.max() <= .86, surface.toString());
        }
    }

    /** From points in the free middle of the room: rays end, and on fronts. */
    @Test
    void whatIsSeen_isAFrontAndTheRoomIsClosed() {
        float[] corners = new float[9 * study.triangles()];
        for (int k = 0; k < corners.length; k++) {
            Vec3 p = study.corner(k / 9, k / 3 % 3).times(0.1);
            corners[k] = (float) (k % 3 == 0 ? p.x() : k % 3 == 1 ? p.y() : p.z());
        }
        RadiosityBounds bounds = new RadiosityBounds(corners);
        Random random = new Random(1);
        for (int ray = 0; ray < 20_000; ray++) {
            Vec3 from = new Vec3(-0.1 + 0.2 * random.nextDouble(), 0.11 + 0.03 * random.nextDouble(),
                    -0.2 * random.nextDouble());
            Vec3 d = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
            float[] hit = new float[3];
            int t = bounds.nearest((float) from.x(), (float) from.y(), (float) from.z(),
                    (float) d.x(), (float) d.y(), (float) d.z(), 2, hit);
            assertTrue(t >= 0, () -> "a ray left the room from " + from + " towards " + d);
            Surface surface = study.surface(t);
            assertTrue(surface.twoSided() || ShippedScenes.normal(study, t).dot(d) < 0,
                    () -> "back of " + surface.name() + " seen from " + from + " towards " + d);
        }
    }
}
