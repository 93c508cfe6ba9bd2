package radiosity.output.raytrace;

import java.util.stream.IntStream;
import radiosity.output.mesh.Elements;
import radiosity.scene.Rgb;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Aabb;
import radiosity.visibility.RadiosityBounds;

/** What rays meet among the elements of a solution: their visible sides, and those of glass also from within. */
final class ElementRays {

    /** What a ray may meet instead of a visible side. */
    static final int NOTHING = -1;
    static final int BACK = -2;

    /** In the hierarchy the scene has a diagonal of 1: no ray is longer. */
    private static final double FAR = 4;
    /** How far from its surface a ray is looked for: more than its coordinates are rounded by. */
    private static final double OFF = 1e-6;

    private final Solution solution;
    private final Vec3 centre;
    private final double scale;
    /** By the triangles of the hierarchy; those from {@code #within} on are turned round: glass from within. */
    private final int[] elements;
    private final int within;
    private final RadiosityBounds bounds;

    /** @param solution with T-junctions closed */
    ElementRays(Solution solution) {
        this.solution = solution;
        Aabb box = Aabb.of(solution.positions());
        centre = box.centre();
        scale = box.diagonal() > 0 ? 1 / box.diagonal() : 1;
        within = solution.elements();
        elements = IntStream.concat(IntStream.range(0, within),
                IntStream.range(0, within).filter(e -> isGlass(solution.surface(e)))).toArray();
        float[] corners = new float[9 * elements.length];
        for (int i = 0; i < 3 * elements.length; i++) {
            int k = i / 3 < within ? i % 3 : (3 - i % 3) % 3;
            Elements.corner(solution, elements[i / 3], k).minus(centre).times(scale).write(corners, 3 * i);
        }
        bounds = new RadiosityBounds(corners);
    }

    private static boolean isGlass(Surface surface) {
        return surface.specular().filter(s -> s.transmits() && !s.thin()).isPresent();
    }

    /**
     * What a ray meets.
     *
     * @param point    scene units, as exactly as the element's corners give it
     * @param v        weight of corner 1
     * @param w        weight of corner 2
     * @param isWithin whether it comes from the back of glass
     */
    record Hit(int element, Vec3 point, double v, double w, boolean isWithin) { }

    /**
     * The first visible side along a ray, or null; it passes through backs.
     *
     * @param from      on a surface, or in the air, scene units
     * @param side      unit normal of that surface on the side to which the ray goes, so that the ray does not meet it
     *                  again where it begins; zero in the air
     * @param direction unit direction
     */
    Hit first(Vec3 from, Vec3 side, Vec3 direction) {
        float[] hit = new float[3];
        Vec3 begin = from.minus(centre).times(scale).plus(side.times(OFF));
        int found = bounds.nearestFront(begin, direction, FAR, false, hit);
        return found < 0 ? null : exact(elements[found], found >= within, from, direction);
    }

    /** Where a ray meets an element, as its corners give it in double; one without area at a corner. */
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
     * The first element along a ray whose visible side it meets, {@link #BACK} where it meets a back before, or
     * {@link #NOTHING}.
     *
     * @param from off the surfaces
     * @param hit  modified: distance, weights of corners 1 and 2
     */
    int element(Vec3 from, Vec3 direction, float[] hit) {
        int found = bounds.nearestFront(from.minus(centre).times(scale), direction, FAR, true, hit);
        return found < 0 ? NOTHING
                : found >= within || Elements.cross(solution, found).dot(direction) >= 0 ? BACK : found;
    }

    /** What an element reflects diffusely at a place, W/m². */
    Rgb reflected(int element, double v, double w) {
        return irradiance(element, v, w).times(reflectance(element, v, w));
    }

    private Rgb reflectance(int element, double v, double w) {
        int triangle = solution.faceOf()[element] >> 1;
        return solution.scene().isMapped(triangle)
                ? solution.scene().look(triangle, Elements.point(solution, element, v, w)).reflectance()
                : solution.surface(element).reflectance();
    }

    /** H between the vertices of an element, W/m². */
    Rgb irradiance(int element, double v, double w) {
        int[] corners = solution.corners();
        return solution.irradianceAt(corners[3 * element]).times(1 - v - w)
                .plus(solution.irradianceAt(corners[3 * element + 1]).times(v))
                .plus(solution.irradianceAt(corners[3 * element + 2]).times(w));
    }

    Solution solution() {
        return solution;
    }
}
