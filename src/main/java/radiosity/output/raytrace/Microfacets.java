package radiosity.output.raytrace;

import radiosity.scene.Vec3;
import radiosity.util.Frame;

/**
 * The microfacets, small mirrors, of which a rough surface is made (B. Walter and others, Microfacet models for
 * refraction through rough surfaces, 2007: GGX), sampled by how much of each the eye sees (E. Heitz, Sampling the GGX
 * distribution of visible normals, 2018).
 */
final class Microfacets {

    private final double width;
    private final Vec3 normal;
    private final Frame frame;
    /** Unit direction to the eye, stretched by the width of the slopes; coordinates along the frame. */
    private final Vec3 stretched;

    /**
     * @param normal    unit normal of the surface
     * @param direction unit direction of a ray that comes from the eye
     * @param roughness in (0, 1]; the width of the slopes is its square
     */
    Microfacets(Vec3 normal, Vec3 direction, double roughness) {
        width = roughness * roughness;
        this.normal = normal;
        frame = Frame.of(normal);
        stretched = new Vec3(-width * direction.dot(frame.u()), -width * direction.dot(frame.v()),
                -direction.dot(normal)).unit();
    }

    /** Unit normal of a facet that the eye sees, chosen by two numbers in [0, 1]. */
    Vec3 normal(double first, double second) {
        double flat = Math.sqrt(stretched.x() * stretched.x() + stretched.y() * stretched.y());
        Vec3 a = flat > 0 ? new Vec3(-stretched.y() / flat, stretched.x() / flat, 0) : new Vec3(1, 0, 0);
        Vec3 b = stretched.cross(a);
        double r = Math.sqrt(first);
        double x = r * StrictMath.cos(2 * Math.PI * second);
        double part = (1 + stretched.z()) / 2;
        double y = (1 - part) * Math.sqrt(Math.max(0, 1 - x * x)) + part * r * StrictMath.sin(2 * Math.PI * second);
        Vec3 h = a.times(x).plus(b.times(y)).plus(stretched.times(Math.sqrt(Math.max(0, 1 - x * x - y * y))));
        return frame.vector(width * h.x(), width * h.y(), Math.max(1e-9, h.z())).unit();
    }

    /**
     * Share of the facets seen by the eye whose light leaves in a direction without meeting other facets (B. Smith,
     * Geometrical shadowing of a random rough surface, 1967).
     */
    double free(Vec3 direction) {
        double cosine = direction.dot(normal);
        double square = cosine * cosine;
        return square == 0 ? 0 : 2 / (1 + Math.sqrt(1 + width * width * (1 - square) / square));
    }
}
