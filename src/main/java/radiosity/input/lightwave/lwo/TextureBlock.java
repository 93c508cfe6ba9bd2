package radiosity.input.lightwave.lwo;

import java.util.Arrays;
import radiosity.scene.ImageMap;

/** An image on a surface as an object describes it: what it varies and how it lies on the points. */
public final class TextureBlock {

    /** How an image is projected; the order is that of the numbers in files. */
    public enum Projection { PLANAR, CYLINDRICAL, SPHERICAL, CUBIC, FRONT, UV }

    /** What it varies: COLR, DIFF, LUMI, ... and LUMC for a colour of emitted light that is not the surface's. */
    public String channel = "COLR";
    /** Path as written; null until it is known. */
    public String image;
    public int clip = -1;
    /** Path of the file; null if it is not found or not needed. */
    public String found;
    public boolean enabled = true;
    public boolean negative;
    /** Placed in the coordinates of the scene and not of the object. */
    public boolean world;
    public double opacity = 1;
    public Projection projection = Projection.PLANAR;
    /** 0 x, 1 y, 2 z. */
    public int axis;
    /** x, y, z of centre and size in the object's coordinates, rotation about the centre in radians (h, p, b). */
    public double[] centre = {0, 0, 0};
    public double[] size = {1, 1, 1};
    public double[] rotation = {0, 0, 0};
    /** Times the image goes round a cylinder or a sphere, and from pole to pole. */
    public double[] turns = {1, 1};
    public ImageMap.Wrap wrapU = ImageMap.Wrap.REPEAT;
    public ImageMap.Wrap wrapV = ImageMap.Wrap.REPEAT;
    /** Name of the texture coordinates of a UV projection. */
    public String map = "";

    /** Whether another image lies on the points just as this one does. */
    public boolean liesAs(TextureBlock other) {
        return projection == other.projection && axis == other.axis && map.equals(other.map)
                && Arrays.equals(centre, other.centre) && Arrays.equals(size, other.size)
                && Arrays.equals(rotation, other.rotation) && Arrays.equals(turns, other.turns);
    }

    public boolean hasSoundNumbers() {
        double sum = opacity;
        for (double[] numbers : new double[][] {centre, size, rotation, turns}) {
            for (double number : numbers) {
                sum += number;
            }
        }
        return Double.isFinite(sum);
    }
}
