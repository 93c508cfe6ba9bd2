package radiosity.output.raytrace;

import radiosity.output.mesh.Elements;
import radiosity.output.raytrace.ElementRays.Hit;
import radiosity.scene.MaterialSample;
import radiosity.scene.Rgb;
import radiosity.scene.Specular;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Hash;
import radiosity.util.R2;

/**
 * Traces rays from the eye through a solution: a specular surface divides a ray into a mirrored and a transmitted ray,
 * which go on until they meet diffuse surfaces (T. Whitted, An improved illumination model for shaded display, 1980;
 * after a diffuse solution: J. Wallace, M. Cohen, D. Greenberg, A two-pass solution to the rendering equation, 1987).
 *
 * <p>The light of a ray follows from the ray, its number and the solution alone, not from threads and their order.
 */
public final class EyeRays {

    /** Least weight in the light that is seen with which a ray is traced. */
    private static final double LEAST = 1e-4;
    /** How often a ray goes on from a specular surface, at most. */
    private static final int DEEPEST = 64;
    /** Number of rays that go on from the first rough surface on a ray's way; from later rough surfaces one goes on. */
    private static final int BLURRED = 32;

    private final Solution solution;
    private final ElementRays rays;
    /** Null if light is interpolated between the mesh's vertices. */
    private final FinalGather gather;
    private final int gathered;

    /**
     * @param solution with T-junctions closed
     * @param gathered number of rays that gather light at the end of a ray; 0 to interpolate between the mesh's
     *                 vertices
     */
    public EyeRays(Solution solution, int gathered) {
        this.solution = solution;
        this.gathered = gathered;
        rays = new ElementRays(solution);
        gather = gathered == 0 ? null : new FinalGather(rays);
    }

    /** Whether a surface of a solution is specular, so that a picture needs these rays. */
    public static boolean shines(Solution solution) {
        return solution.scene().surfaces().stream().anyMatch(surface -> surface.specular().isPresent());
    }

    /**
     * The light that is seen of an element along a ray: the radiosity of a diffuse surface that looks as bright, W/m².
     *
     * @param eye       origin of the ray, scene units
     * @param direction unit direction of the ray
     * @param ray       number of the ray in the picture
     */
    public Rgb seen(int element, Vec3 eye, Vec3 direction, long ray) {
        return along(rays.exact(element, false, eye, direction), direction, 1, 0, new Way(0, ray, gathered, false));
    }

    /**
     * Irradiance at a point of an element, gathered anew, W/m²; only if the number of gathering rays is above 0.
     *
     * @param first number of the first eye ray to the point
     * @param count number of eye rays to the point
     */
    public Rgb irradiance(int element, Vec3 point, long first, int count) {
        return gather.irradiance(point, Elements.normal(solution, element), first * gathered, count * gathered);
    }

    /**
     * The number of a pixel along a curve through all pixels (G. Morton, A computer oriented geodetic data base and a
     * new technique in file sequencing, 1966): pixels near each other have numbers near each other, so that gathering
     * rays, numbered by pixels, are spread evenly over a neighbourhood, and their noise is fine.
     */
    public static long number(int column, int row) {
        long number = 0;
        for (int bit = 0; bit < Integer.SIZE - 1; bit++) {
            number |= (column >>> bit & 1L) << 2 * bit | (row >>> bit & 1L) << 2 * bit + 1;
        }
        return number;
    }

    /**
     * The state of a ray on its way from the eye.
     *
     * @param seed    of the choices on the ray's way
     * @param number  of the ray among rays with the same seed
     * @param end     number of rays that gather light where the ray ends; 0 to interpolate
     * @param blurred whether a rough surface was on the ray's way
     */
    private record Way(long seed, long number, int end, boolean blurred) {

        /** The way of ray k that goes on from a rough surface. */
        Way blurred(long k) {
            return new Way(Hash.mix(seed, k), 0, 0, true);
        }

        /** Two numbers in [0, 1) that choose the facet from which ray k goes on. */
        double[] choice(long k) {
            return new double[] {(R2.u(k) + (seed >>> 40) * 0x1p-24) % 1,
                (R2.v(k) + (seed >>> 16 & 0xFFFFFF) * 0x1p-24) % 1};
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

    /**
     * Radiosity of a diffuse surface, W/m².
     *
     * @param share of the diffusely reflected light that is seen
     */
    private Rgb diffuse(Hit hit, Vec3 normal, double share, Way way) {
        MaterialSample look = solution.scene().material(solution.faceOf()[hit.element()] >> 1, hit.point());
        if (look.reflectance().max() * share <= 0) {
            return look.exitance();
        }
        Rgb h = way.end == 0 ? rays.irradiance(hit.element(), hit.v(), hit.w())
                : gather.irradiance(hit.point(), normal, way.number * way.end, way.end);
        return look.radiosity(h.times(share));
    }

    /**
     * The point where a ray meets a specular surface.
     *
     * @param normal unit normal on the side from which the ray comes
     * @param weight of the ray in the light that is seen
     * @param depth  how often the ray has gone on
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
     * Light from a mirrored ray and, if the surface transmits light, from a transmitted ray.
     *
     * @param normal of the mirror: the normal of the surface or of a facet
     * @param facets null if the surface is smooth
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
     * Light that a ray that goes on brings, W/m²; black if its weight is too small or it leaves on the wrong side.
     *
     * @param share     of the ray's light that is seen
     * @param direction unit direction; null if no ray goes on
     * @param side      1 for a ray back to the side from which light was traced, -1 for a ray beyond the surface
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
