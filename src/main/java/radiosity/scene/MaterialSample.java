package radiosity.scene;

/**
 * What there is to see of a surface at a point, or in the mean under a triangle.
 *
 * @param exitance    E, W/m²
 * @param reflectance rho, in [0, 1)
 */
public record MaterialSample(Rgb exitance, Rgb reflectance) {

    /** B = E + rho H (equation 1), W/m². */
    public Rgb radiosity(Rgb irradiance) {
        return exitance.plus(irradiance.times(reflectance));
    }
}
