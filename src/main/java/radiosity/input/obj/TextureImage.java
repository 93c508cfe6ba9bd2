package radiosity.input.obj;

/**
 * An image of a material and its mapping: texture coordinates are multiplied by the scale, then the offset is added.
 *
 * @param file    path as written
 * @param scaleU  scale of u
 * @param scaleV  scale of v
 * @param offsetU offset of u
 * @param offsetV offset of v
 * @param clamp   whether the image is continued by its edge pixels and not repeated
 */
record TextureImage(String file, double scaleU, double scaleV, double offsetU, double offsetV, boolean clamp) {

    /** Whether another image has the same mapping, whatever its file. */
    boolean liesAs(TextureImage other) {
        return equals(new TextureImage(file, other.scaleU, other.scaleV, other.offsetU, other.offsetV, other.clamp));
    }
}
