package radiosity.scene;

/**
 * Exitance and reflectance of a surface at a point, or their means over a triangle.
 *
 * @param exitance    E, W/m²
 * @param reflectance rho, in [0, 1)
 */
public record MaterialSample(Rgb exitance, Rgb reflectance) {

    /** Radiosity B = E + rho H (equation 1), W/m², from the irradiance H in W/m². */
    public Rgb radiosity(Rgb irradiance) {
        return exitance.plus(irradiance.times(reflectance));
    }
}
