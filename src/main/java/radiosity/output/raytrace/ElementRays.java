package radiosity.output.raytrace;

import java.util.stream.IntStream;
import radiosity.output.mesh.Elements;
import radiosity.scene.Rgb;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Aabb;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.ScaledBounds;

/** Finds what rays meet among the elements of a solution: visible sides, and sides of glass also from within. */
final class ElementRays {

    /** Results where a ray meets no visible side: no surface at all, or the back of one. */
    static final int NOTHING = -1;
    static final int BACK = -2;

    /** Distance of a ray's origin from its surface in the hierarchy: more than its coordinates are rounded by. */
    private static final double OFF = 1e-6;

    private final Solution solution;
    /** The element of each triangle of the hierarchy; from {@code #within} on, elements of glass, seen from within. */
    private final int[] elements;
    private final int within;
    private final ScaledBounds scaled;

    /** @param solution with T-junctions closed */
    ElementRays(Solution solution) {
        this.solution = solution;
        within = solution.elements();
        elements = IntStream.concat(IntStream.range(0, within),
                IntStream.range(0, within).filter(e -> isGlass(solution.surface(e)))).toArray();
        scaled = new ScaledBounds(Aabb.of(solution.positions()), elements.length,
                i -> Elements.corner(solution, elements[i / 3], i / 3 < within ? i % 3 : (3 - i % 3) % 3));
    }

    private static boolean isGlass(Surface surface) {
        return surface.specular().filter(s -> s.transmits() && !s.thin()).isPresent();
    }

    /**
     * The point where a ray meets an element.
     *
     * @param point    scene units, as exact as the element's corners
     * @param v        weight of corner 1
     * @param w        weight of corner 2
     * @param isWithin whether the ray meets glass from within
     */
    record Hit(int element, Vec3 point, double v, double w, boolean isWithin) { }

    /**
     * The first visible side along a ray, or null; the ray passes through backs.
     *
     * @param from      origin on a surface, or in the air, scene units
     * @param side      unit normal of the origin's surface on the side to which the ray goes, so that the ray does not
     *                  meet this surface where it begins; zero in the air
     * @param direction unit direction
     */
    Hit first(Vec3 from, Vec3 side, Vec3 direction) {
        float[] hit = new float[3];
        Vec3 begin = scaled.unit(from).plus(side.times(OFF));
        int found = scaled.bounds.nearestFront(begin, direction, RadiosityBounds.ACROSS, false, hit);
        return found < 0 ? null : exact(elements[found], found >= within, from, direction);
    }

    /** The point where a ray meets the plane of an element, in double; corner 0 of an element without area. */
    Hit exact(int element, boolean isWithin, Vec3 from, Vec3 direction) {
        Vec3 a = Elements.corner(solution, element, 0);
        Vec3 ab = Elements.corner(solution, element, 1).minus(a);
        Vec3 ac = Elements.corner(solution, element, 2).minus(a);
        Vec3 p = direction.cross(ac);
        Vec3 s = from.minus(a);
        Vec3 q = s.cross(ab);
        double det = ab.dot(p);
        double v = det == 0 ? 0 : s.dot(p) / det;
        double w = det == 0 ? 0 : direction.dot(q) / det;
        return new Hit(element, a.plus(ab.times(v)).plus(ac.times(w)), v, w, isWithin);
    }

    /**
     * The first element along a ray whose visible side the ray meets, {@link #BACK} if the ray meets a back before, or
     * {@link #NOTHING}.
     *
     * @param from origin off the surfaces, scene units
     * @param hit  receives the distance, of the scene's diagonal, and the weights of corners 1 and 2
     */
    int element(Vec3 from, Vec3 direction, float[] hit) {
        int found = scaled.bounds.nearestFront(scaled.unit(from), direction, RadiosityBounds.ACROSS, true, hit);
        return found < 0 ? NOTHING
                : found >= within || Elements.cross(solution, found).dot(direction) >= 0 ? BACK : found;
    }

    /** Radiosity that an element reflects diffusely at a point, W/m². */
    Rgb reflected(int element, double v, double w) {
        return irradiance(element, v, w).times(reflectance(element, v, w));
    }

    private Rgb reflectance(int element, double v, double w) {
        int triangle = solution.faceOf()[element] >> 1;
        return solution.scene().isMapped(triangle)
                ? solution.scene().material(triangle, Elements.point(solution, element, v, w)).reflectance()
                : solution.surface(element).reflectance();
    }

    /** Irradiance H at a point of an element, interpolated between the vertices, W/m². */
    Rgb irradiance(int element, double v, double w) {
        return Elements.irradiance(solution, element, v, w);
    }

    Solution solution() {
        return solution;
    }
}
