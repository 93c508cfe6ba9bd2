package radiosity.input.obj;

/**
 * An image of a material and how it lies: texture coordinates are multiplied by the scale, then the offset is added.
 *
 * @param file    as written
 * @param scaleU  of u
 * @param scaleV  of v
 * @param offsetU of u
 * @param offsetV of v
 * @param clamp   nothing is repeated
 */
record TextureImage(String file, double scaleU, double scaleV, double offsetU, double offsetV, boolean clamp) {

    /** Whether another lies on the surface in the same way, wherever its file is. */
    boolean liesAs(TextureImage other) {
        return equals(new TextureImage(file, other.scaleU, other.scaleV, other.offsetU, other.offsetV, other.clamp));
    }
}
