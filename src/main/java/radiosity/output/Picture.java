package radiosity.output;

/**
 * A picture in linear light.
 *
 * @param width  pixels
 * @param height pixels
 * @param rgb    3 per pixel, from the upper left corner, row by row
 */
record Picture(int width, int height, float[] rgb) {
}
