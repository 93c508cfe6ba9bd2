package radiosity.accuracy.reference;

/**
 * How a rectangle emits and reflects; diffuse.
 *
 * @param name        unique within its room
 * @param exitance    emitted radiosity per channel, W/m²; 3 values, not modified
 * @param reflectance reflected / arriving per channel; 3 values in [0, 1), not modified
 */
record Material(String name, double[] exitance, double[] reflectance) {

    static Material wall(String name, double r, double g, double b) {
        return new Material(name, new double[3], new double[] {r, g, b});
    }

    boolean emits() {
        return exitance[0] + exitance[1] + exitance[2] > 0;
    }
}
