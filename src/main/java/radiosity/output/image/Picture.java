package radiosity.output.image;

/**
 * A picture in linear light.
 *
 * @param width  pixels
 * @param height pixels
 * @param rgb    3 per pixel, from the upper left corner, row by row
 */
public record Picture(int width, int height, float[] rgb) {
}
