package radiosity.lightwave;

import java.util.Arrays;
import radiosity.scene.ImageMap;

/** An image on a surface as an object describes it: what it varies and how it lies on the points. */
final class TextureBlock {

    /** How an image is projected; the order is that of the numbers in files. */
    enum Projection { PLANAR, CYLINDRICAL, SPHERICAL, CUBIC, FRONT, UV }

    /** What it varies: COLR, DIFF, LUMI, ... and LUMC for a colour of emitted light that is not the surface's. */
    String channel = "COLR";
    /** Path as written; null until it is known. */
    String image;
    int clip = -1;
    /** Path of the file; null if it is not found or not needed. */
    String found;
    boolean enabled = true;
    boolean negative;
    /** Placed in the coordinates of the scene and not of the object. */
    boolean world;
    double opacity = 1;
    Projection projection = Projection.PLANAR;
    /** 0 x, 1 y, 2 z. */
    int axis;
    /** x, y, z of centre and size in the object's coordinates, rotation about the centre in radians (h, p, b). */
    double[] centre = {0, 0, 0};
    double[] size = {1, 1, 1};
    double[] rotation = {0, 0, 0};
    /** Times the image goes round a cylinder or a sphere, and from pole to pole. */
    double[] turns = {1, 1};
    ImageMap.Wrap wrapU = ImageMap.Wrap.REPEAT;
    ImageMap.Wrap wrapV = ImageMap.Wrap.REPEAT;
    /** Name of the texture coordinates of a UV projection. */
    String map = "";

    /** Whether another image lies on the points just as this one does. */
    boolean liesAs(TextureBlock other) {
        return projection == other.projection && axis == other.axis && map.equals(other.map)
                && Arrays.equals(centre, other.centre) && Arrays.equals(size, other.size)
                && Arrays.equals(rotation, other.rotation) && Arrays.equals(turns, other.turns);
    }

    boolean hasSoundNumbers() {
        double sum = opacity;
        for (double[] numbers : new double[][] {centre, size, rotation, turns}) {
            for (double number : numbers) {
                sum += number;
            }
        }
        return Double.isFinite(sum);
    }
}
