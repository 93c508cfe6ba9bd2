package radiosity.input.lightwave.lwo;

import java.util.Arrays;
import radiosity.scene.ImageMap;

/** An image on a surface as an object describes it: the quantity that it varies and its projection onto the points. */
public final class TextureBlock implements Cloneable {

    /** Projections of an image, in the order of their numbers in files. */
    public enum Projection { PLANAR, CYLINDRICAL, SPHERICAL, CUBIC, FRONT, UV }

    /** The varied quantity: COLR, DIFF, LUMI, ..., or LUMC for a colour of emitted light other than the surface's. */
    public String channel = "COLR";
    /** Path as written in the object; null until it is known. */
    public String image;
    public int clip = -1;
    /** Path of the image's file; null if the file was not found or not searched. */
    public String found;
    public boolean enabled = true;
    public boolean negative;
    /** Whether the texture is placed in the scene's coordinates instead of the object's. */
    public boolean world;
    public double opacity = 1;
    public Projection projection = Projection.PLANAR;
    /** Axis of the projection: 0 x, 1 y, 2 z. */
    public int axis;
    /** Centre and size x, y, z in the object's coordinates; heading, pitch, bank of the rotation, radians. */
    public double[] centre = {0, 0, 0};
    public double[] size = {1, 1, 1};
    public double[] rotation = {0, 0, 0};
    /** Number of repetitions around a cylinder or a sphere, and from pole to pole. */
    public double[] turns = {1, 1};
    public ImageMap.Wrap wrapU = ImageMap.Wrap.REPEAT;
    public ImageMap.Wrap wrapV = ImageMap.Wrap.REPEAT;
    /** Name of the texture coordinates of a UV projection. */
    public String map = "";

    /** A block of the same image on the same points, which varies a channel of its own. */
    TextureBlock on(String otherChannel) {
        try {
            TextureBlock copy = (TextureBlock) clone();
            copy.channel = otherChannel;
            return copy;
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException("blocks can be cloned", e);
        }
    }

    /** Whether another image has the same projection onto the points, and goes on alike beyond its edges. */
    public boolean liesAs(TextureBlock other) {
        return wrapU == other.wrapU && wrapV == other.wrapV
                && projection == other.projection && axis == other.axis && map.equals(other.map)
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
