package radiosity.output.raytrace;

import radiosity.formfactor.PointSequence;
import radiosity.output.mesh.Elements;
import radiosity.output.raytrace.ElementRays.Hit;
import radiosity.scene.MaterialSample;
import radiosity.scene.Rgb;
import radiosity.scene.Specular;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Hash;

/**
 * What the eye sees of a solution along a ray: at surfaces that shine the ray is divided, and goes on until it meets
 * what is diffuse (T. Whitted, An improved illumination model for shaded display, 1980; after a diffuse solution: J.
 * Wallace, M. Cohen, D. Greenberg, A two-pass solution to the rendering equation, 1987).
 *
 * <p>Everything follows from the ray, its number and the solution: no thread or order has a part in it.
 */
public final class EyeRays {

    /** A ray with less influence on what is seen is left out. */
    private static final double LEAST = 1e-4;
    /** How often a ray goes on, at most. */
    private static final int DEEPEST = 64;
    /** Rays that go on from a rough surface, where it is the first one on the way. */
    private static final int BLURRED = 32;

    private final Solution solution;
    private final ElementRays rays;
    /** Null where light between the mesh's vertices is taken. */
    private final FinalGather gather;
    private final int gathered;

    /**
     * @param solution with T-junctions closed
     * @param gathered rays by which the light at the end of a ray is gathered; 0: between the mesh's vertices
     */
    public EyeRays(Solution solution, int gathered) {
        this.solution = solution;
        this.gathered = gathered;
        rays = new ElementRays(solution);
        gather = gathered == 0 ? null : new FinalGather(rays);
    }

    /** Whether a picture of a solution needs these rays: something shines. */
    public static boolean shines(Solution solution) {
        return solution.scene().surfaces().stream().anyMatch(surface -> surface.specular().isPresent());
    }

    /**
     * What is seen of a place on an element: the radiosity of a diffuse surface that looks as bright, W/m².
     *
     * @param eye       where the ray begins, scene units
     * @param direction unit direction of the ray from the eye
     * @param ray       its number in the picture
     */
    public Rgb seen(int element, Vec3 eye, Vec3 direction, long ray) {
        return along(rays.exact(element, false, eye, direction), direction, 1, 0, new Way(0, ray, gathered, false));
    }

    /**
     * The light that arrives at a place on an element, gathered anew, W/m².
     *
     * @param first number of the first of the rays to the place
     * @param count number of these rays
     */
    public Rgb irradiance(int element, Vec3 point, long first, int count) {
        return gather.irradiance(point, Elements.normal(solution, element), first * gathered, count * gathered);
    }

    /**
     * The number of a pixel along a curve through all of them (G. Morton, 1966): those near each other have numbers
     * near each other, so that their rays, numbered by pixels, are spread evenly, and what noise they have is fine.
     */
    public static long number(int column, int row) {
        long number = 0;
        for (int bit = 0; bit < Integer.SIZE - 1; bit++) {
            number |= (column >>> bit & 1L) << 2 * bit | (row >>> bit & 1L) << 2 * bit + 1;
        }
        return number;
    }

    /**
     * How a ray came here.
     *
     * @param seed    of what is chosen on its way
     * @param number  among those with the same seed
     * @param end     rays to gather with where it ends
     * @param blurred whether a rough surface was on its way
     */
    private record Way(long seed, long number, int end, boolean blurred) {

        /** By one of the normals of a rough surface. */
        Way blurred(long k) {
            return new Way(Hash.mix(seed, k), 0, 0, true);
        }

        /** Two numbers from 0 to 1. */
        double[] choice(long k) {
            return new double[] {(PointSequence.u(k) + (seed >>> 40) * 0x1p-24) % 1,
                (PointSequence.v(k) + (seed >>> 16 & 0xFFFFFF) * 0x1p-24) % 1};
        }
    }

    private Rgb along(Hit hit, Vec3 direction, double weight, int depth, Way way) {
        if (hit == null) {
            return Rgb.BLACK;
        }
        Specular specular = solution.surface(hit.element()).specular().orElse(null);
        Vec3 normal = Elements.normal(solution, hit.element());
        if (specular == null) {
            return diffuse(hit, normal, 1, way);
        }
        Place place = new Place(hit, specular, hit.isWithin() ? normal.times(-1) : normal, weight, depth);
        Rgb own = hit.isWithin() ? Rgb.BLACK
                : diffuse(hit, normal, specular.diffuse() * (1 - place.rise(direction, normal)), way);
        return own.plus(specular.roughness() == 0 ? divided(place, direction, place.normal, null, way)
                : rough(place, direction, way));
    }

    /** @param share of what is reflected diffusely that is seen */
    private Rgb diffuse(Hit hit, Vec3 normal, double share, Way way) {
        MaterialSample look = solution.scene().look(solution.faceOf()[hit.element()] >> 1, hit.point());
        if (look.reflectance().max() * share <= 0) {
            return look.exitance();
        }
        Rgb h = way.end == 0 ? rays.irradiance(hit.element(), hit.v(), hit.w())
                : gather.irradiance(hit.point(), normal, way.number * way.end, way.end);
        return look.radiosity(h.times(share));
    }

    /**
     * Where a ray meets what shines.
     *
     * @param normal on the side from which the ray comes
     * @param weight of the ray
     */
    private record Place(Hit hit, Specular specular, Vec3 normal, double weight, int depth) {

        double index() {
            return hit.isWithin() ? 1 / specular.index() : specular.index();
        }

        double rise(Vec3 direction, Vec3 facing) {
            return Fresnel.rise(-direction.dot(facing), index());
        }
    }

    private Rgb rough(Place place, Vec3 direction, Way way) {
        Microfacets facets = new Microfacets(place.normal, direction, place.specular.roughness());
        int count = way.blurred ? 1 : BLURRED;
        Rgb sum = Rgb.BLACK;
        for (int i = 0; i < count; i++) {
            long k = way.number * BLURRED + i + 1;
            double[] choice = way.choice(k);
            sum = sum.plus(divided(place, direction, facets.normal(choice[0], choice[1]), facets, way.blurred(k)));
        }
        return sum.times(1.0 / count);
    }

    /**
     * What a mirror shows, and what is behind it.
     *
     * @param normal of the mirror: that of the surface, or of one of its facets
     * @param facets null where it is smooth
     */
    private Rgb divided(Place place, Vec3 direction, Vec3 normal, Microfacets facets, Way way) {
        Specular specular = place.specular;
        double rise = place.rise(direction, normal);
        Vec3 mirrored = Fresnel.mirrored(direction, normal);
        Rgb reflected = specular.reflectance().times(1 - rise).plus(Rgb.grey(rise));
        Rgb sum = on(place, reflected, mirrored, 1, facets, way);
        if (specular.transmits()) {
            Vec3 beyond = specular.thin() ? Fresnel.mirrored(mirrored, place.normal)
                    : Fresnel.refracted(direction, normal, place.index());
            sum = sum.plus(on(place, specular.transmittance().times(1 - rise), beyond, -1, facets, way));
        }
        return sum;
    }

    /**
     * What a ray that goes on brings.
     *
     * @param share     of it that is seen
     * @param direction unit direction, or null where none goes on
     * @param side      1 back to where it came from, -1 beyond the surface
     */
    private Rgb on(Place place, Rgb share, Vec3 direction, int side, Microfacets facets, Way way) {
        double weight = place.weight * share.max();
        if (weight < LEAST || place.depth == DEEPEST || direction == null || side * direction.dot(place.normal) <= 0) {
            return Rgb.BLACK;
        }
        Hit next = rays.first(place.hit.point(), place.normal.times(side), direction);
        Rgb brought = along(next, direction, weight, place.depth + 1, way);
        return share.times(brought).times(facets == null ? 1 : facets.free(direction));
    }
}
