package radiosity.viewer;

import java.util.List;
import java.util.Locale;
import radiosity.output.image.ToneMapping;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Rgb;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/**
 * The light at a point that the user has clicked on.
 *
 * @param surface     surface at the point
 * @param back        whether the point is on the back of the surface
 * @param point       scene units
 * @param radiosity   B, W/m²
 * @param irradiance  H, W/m²
 * @param reflectance rho, in [0, 1)
 */
record Probe(Surface surface, boolean back, Vec3 point, Rgb radiosity, Rgb irradiance, Rgb reflectance) {

    /** @param mesh the mesh that was hit, with the light shown */
    static Probe of(Obstacles.Hit hit, Mesh mesh, Vec3 point) {
        int e = hit.element();
        double u = 1 - hit.v() - hit.w();
        return new Probe(mesh.surface(), mesh.back(), point,
                mix(mesh.radiosity(e, 0), mesh.radiosity(e, 1), mesh.radiosity(e, 2), u, hit),
                mix(mesh.irradiance(e, 0), mesh.irradiance(e, 1), mesh.irradiance(e, 2), u, hit),
                mix(mesh.reflectance(e, 0), mesh.reflectance(e, 1), mesh.reflectance(e, 2), u, hit));
    }

    private static Rgb mix(Rgb a, Rgb b, Rgb c, double u, Obstacles.Hit hit) {
        return a.times(u).plus(b.times(hit.v())).plus(c.times(hit.w()));
    }

    /** Describes the light to the user, a line per quantity. */
    List<String> lines() {
        return List.of("surface      " + surface.name() + (back ? " (back)" : ""),
                "radiosity    " + text(radiosity) + " W/m²",
                "irradiance   " + text(irradiance) + " W/m²",
                String.format(Locale.ROOT, "luminance Y  %.4g W/m², irradiance %.4g W/m²",
                        ToneMapping.luminance(radiosity), ToneMapping.luminance(irradiance)),
                "reflectance  " + text(reflectance),
                "exitance     " + text(surface.exitance()) + " W/m²",
                "at           " + text(new Rgb(point.x(), point.y(), point.z())));
    }

    private static String text(Rgb v) {
        return String.format(Locale.ROOT, "%.4g  %.4g  %.4g", v.r(), v.g(), v.b());
    }
}
