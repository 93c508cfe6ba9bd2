package radiosity.output.image;

/**
 * A picture in linear light.
 *
 * @param width  pixels
 * @param height pixels
 * @param rgb    red, green and blue of each pixel, row by row from the upper left corner
 */
public record Picture(int width, int height, float[] rgb) {

    /** The largest component of all pixels; 0 if none is above 0. */
    public double most() {
        double most = 0;
        for (float light : rgb) {
            most = Math.max(most, light);
        }
        return most;
    }
}
