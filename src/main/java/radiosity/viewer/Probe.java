package radiosity.viewer;

import java.util.List;
import java.util.Locale;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Rgb;
import radiosity.scene.Surface;
import radiosity.scene.Units;
import radiosity.scene.Vec3;

/**
 * The light at a point that the user has clicked on.
 *
 * @param surface     surface at the point
 * @param back        whether the point is on the back of the surface
 * @param point       scene units
 * @param radiosity   B, W/m² or lm/m²
 * @param irradiance  H, W/m² or lx
 * @param reflectance rho, in [0, 1)
 * @param units       of the light
 */
record Probe(Surface surface, boolean back, Vec3 point, Rgb radiosity, Rgb irradiance, Rgb reflectance, Units units) {

    /**
     * The light at a point.
     *
     * @param mesh  the mesh that was hit, with the light shown
     * @param units of the light
     */
    static Probe of(Obstacles.Hit hit, Mesh mesh, Vec3 point, Units units) {
        int e = hit.element();
        double u = 1 - hit.v() - hit.w();
        return new Probe(mesh.surface(), mesh.back(), point,
                mix(mesh.radiosity(e, 0), mesh.radiosity(e, 1), mesh.radiosity(e, 2), u, hit),
                mix(mesh.irradiance(e, 0), mesh.irradiance(e, 1), mesh.irradiance(e, 2), u, hit),
                mix(mesh.reflectance(e, 0), mesh.reflectance(e, 1), mesh.reflectance(e, 2), u, hit), units);
    }

    private static Rgb mix(Rgb a, Rgb b, Rgb c, double u, Obstacles.Hit hit) {
        return a.times(u).plus(b.times(hit.v())).plus(c.times(hit.w()));
    }

    /** Describes the light to the user, a line per quantity. */
    List<String> lines() {
        return List.of("surface      " + surface.name() + (back ? " (back)" : ""),
                "radiosity    " + text(radiosity) + " " + Units.raised(units.exitance()),
                "irradiance   " + text(irradiance) + " " + Units.raised(units.irradiance()),
                String.format(Locale.ROOT, "luminance Y  %.4g %s, %s %.4g %s",
                        units.luminance(radiosity), Units.raised(units.luminance()), units.irradianceWord(),
                        Units.weighted(irradiance), Units.raised(units.irradiance())),
                "reflectance  " + text(reflectance),
                "exitance     " + text(surface.exitance()) + " " + Units.raised(units.exitance()),
                "at           " + text(new Rgb(point.x(), point.y(), point.z())));
    }

    private static String text(Rgb v) {
        return String.format(Locale.ROOT, "%.4g  %.4g  %.4g", v.r(), v.g(), v.b());
    }
}
