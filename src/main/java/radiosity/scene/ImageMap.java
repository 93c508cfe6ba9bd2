package radiosity.scene;

/**
 * An image that varies what a surface reflects or emits.
 *
 * <p>At texture coordinates (u, v) of a triangle ({@link Scene#textureCoordinates()}) the varied quantity is
 * {@code (1 - opacity) base + opacity scale image(u, v)} per channel, where base is that of the {@link Surface} and the
 * image's values run from 0 to 1.
 *
 * @param target   what is varied
 * @param image    found by the reader
 * @param scale    factor of the image's values: of reflectance without unit, of exitance in W/m²
 * @param grey     the mean of the image's three channels counts, not each of them
 * @param coded    the image's values are sRGB whatever the user says, and are made linear
 * @param negative 1 - value is taken for each value of the image
 * @param opacity  share of the image, in [0, 1]
 * @param wrapU    what stands outside of u in [0, 1]
 * @param wrapV    what stands outside of v in [0, 1]
 */
public record ImageMap(Target target, ImageSource image, Rgb scale, boolean grey, boolean coded, boolean negative,
                       double opacity, Wrap wrapU, Wrap wrapV) {

    /** What an image varies. */
    public enum Target { REFLECTANCE, EXITANCE }

    /** How an image goes on beyond its edges: not at all (base value), again, mirrored, or with its last pixel. */
    public enum Wrap { NONE, REPEAT, MIRROR, EDGE }

    public ImageMap {
        if (!(opacity >= 0 && opacity <= 1) || !scale.isFinite()) {
            throw new IllegalArgumentException("image " + image.name()
                    + ": expected an opacity in [0, 1] and a finite scale, got " + opacity + " and " + scale);
        }
    }
}
