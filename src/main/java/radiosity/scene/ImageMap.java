package radiosity.scene;

/**
 * An image that varies the reflectance or the exitance of a surface.
 *
 * <p>At texture coordinates (u, v) of a triangle ({@link Scene#textureCoordinates()}) the varied quantity is
 * {@code (1 - opacity) base + opacity scale image(u, v)} per channel, where base is the quantity of the {@link Surface}
 * and the image's values run from 0 to 1.
 *
 * @param target   the varied quantity
 * @param image    the image as the reader found it
 * @param scale    factor of the image's values: without unit for reflectance, W/m² for exitance
 * @param grey     whether the mean of the image's three channels is used for each channel
 * @param coded    whether the image's values are sRGB codes to be made linear, whatever the user's options say
 * @param negative whether 1 - value is taken for each value of the image
 * @param opacity  share of the image, in [0, 1]
 * @param wrapU    how the image continues where u is outside of [0, 1]
 * @param wrapV    how the image continues where v is outside of [0, 1]
 */
public record ImageMap(Target target, ImageSource image, Rgb scale, boolean grey, boolean coded, boolean negative,
                       double opacity, Wrap wrapU, Wrap wrapV) {

    /** The quantity that an image varies. */
    public enum Target { REFLECTANCE, EXITANCE }

    /** How an image continues beyond its edges: by the base value, repeated, mirrored, or by its nearest edge pixel. */
    public enum Wrap { NONE, REPEAT, MIRROR, EDGE }

    public ImageMap {
        if (!(opacity >= 0 && opacity <= 1) || !scale.isFinite()) {
            throw new IllegalArgumentException("image " + image.name()
                    + ": expected an opacity in [0, 1] and a finite scale, got " + opacity + " and " + scale);
        }
    }
}
