package radiosity.scene;

/**
 * A source without geometry: it neither occludes nor shows, and shoots before any patch.
 *
 * @param name      for messages and layers
 * @param kind      what it is
 * @param power     distant: irradiance at normal incidence (W/m²); point and spot: irradiance at distance
 *                  {@code range} (W/m²), falling with 1/r²; area: exitance (W/m²)
 * @param position  of a point, spot or (centre of) area light, scene units
 * @param direction unit direction in which it shines (not used by a point light)
 * @param right     half edge of an area light, scene units; zero for others
 * @param up        other half edge of an area light
 * @param range     distance at which a point or spot light has its nominal irradiance, scene units, above 0
 * @param cone      half angle of a spot's cone, radians
 * @param edge      width of the soft edge inside that cone, radians
 */
public record Light(String name, Kind kind, Rgb power, Vec3 position, Vec3 direction, Vec3 right, Vec3 up,
                    double range, double cone, double edge) {

    /** The kinds of light that are evaluated. */
    public enum Kind { DISTANT, POINT, SPOT, AREA }
}
