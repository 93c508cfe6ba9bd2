package radiosity.scenes;

/**
 * A LightWave surface: reflectance = diffuse x colour, exitance = luminosity x colour in W/m².
 *
 * @param red   colour, 0 to 1, as green and blue
 * @param sided 1: reflects and emits on its front only, 3: on both sides
 * @param mirrored    part of what arrives that is mirrored
 * @param transparent part of what is not mirrored that goes through
 * @param index       of refraction
 */
record Material(String name, double red, double green, double blue, double diffuse, double luminosity, int sided,
        double mirrored, double transparent, double index) {

    /** One that is neither mirror nor glass. */
    Material(String name, double red, double green, double blue, double diffuse, double luminosity, int sided) {
        this(name, red, green, blue, diffuse, luminosity, sided, 0, 0, 1);
    }

    static Material mirror(String name, double mirrored) {
        return new Material(name, 1, 1, 1, 0, 0, 1, mirrored, 0, 1);
    }

    static Material glass(String name, double index) {
        return new Material(name, 1, 1, 1, 0, 0, 1, 0, 1, index);
    }

    /** Reflects the given part of each channel on its front. */
    static Material paint(String name, double red, double green, double blue) {
        return new Material(name, red, green, blue, 1, 0, 1);
    }

    /**
     * Emits on its front.
     *
     * @param red        exitance of the channel in W/m², as green and blue
     * @param brightness reflectance of the strongest channel; the others in proportion, as one colour serves both
     */
    static Material lamp(String name, double red, double green, double blue, double brightness) {
        double strongest = Math.max(red, Math.max(green, blue));
        return new Material(name, red / strongest, green / strongest, blue / strongest, brightness, strongest, 1);
    }

    Material onBothSides() {
        return new Material(name, red, green, blue, diffuse, luminosity, 3);
    }
}
