package radiosity.mesh.face;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.scene.ImageMap;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;

/** An image of 64 x 64 pixels, black on the left and white on the right, on a triangle. */
class FaceMapTest {

    private static final double[][] ONE = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};

    private static FaceMap map(double share) {
        float[] rgb = new float[3 * 64 * 64];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i / 3 % 64 < 32 ? 0 : 1;
        }
        Raster image = new Raster(64, 64, rgb, ImageMap.Wrap.EDGE, ImageMap.Wrap.EDGE, Rgb.BLACK);
        return new FaceMap(new FaceMap.Look(Optional.of(image), Rgb.BLACK, new double[] {0, 1, 0},
                new double[] {0, 0, 1}, ONE, share));
    }

    /** Children 0 and 2 are left of the middle, child 1 is right. */
    @Test
    void nodesOfALargeFace_haveTheirOwnMeans() {
        FaceMap map = map(1e-3);
        assertEquals(0, map.at(NodePath.child(NodePath.FACE, 0), 0), .01);
        assertEquals(1, map.at(NodePath.child(NodePath.FACE, 1), 0), .01);
        assertEquals(.25, map.at(NodePath.FACE, 0), .01);
    }

    /** A hundred thousand small faces, each with the whole image, would otherwise take gigabytes. */
    @Test
    void nodesOfAFaceThatIsTinyInItsScene_haveTheMeanOfTheFace() {
        FaceMap map = map(1e-7);
        assertEquals(.25, map.at(NodePath.child(NodePath.FACE, 1), 0), .05);
    }
}
