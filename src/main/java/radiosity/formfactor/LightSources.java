package radiosity.formfactor;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.ReceivingPoints;
import radiosity.mesh.face.Faces;
import radiosity.scene.Light;
import radiosity.scene.Luminaire;
import radiosity.scene.Vec3;
import radiosity.util.Hash;
import radiosity.util.R2;
import radiosity.visibility.RadiosityBounds;

/**
 * The direct light of sources without geometry. Their light is added to a vertex when the vertex is made, before any
 * patch shoots. Any number of threads may use one object.
 *
 * <p>Source of the inverse square law and the cosine law: J. H. Lambert, Photometria, 1760.
 */
public final class LightSources {

    /** Sample points by which the visible share of an area light is estimated. */
    private static final int SAMPLES = 32;
    /** Ratio of distance to size from which on a part of a luminaire is treated as a point. */
    private static final double SMALL = 12;
    /** Part of its length by which a ray to a luminaire ends early: a ceiling in the lamp's plane is no obstacle. */
    private static final double MOUNTED = 1e-4;
    /** Largest number of points along an edge of a luminaire. */
    private static final int MOST_POINTS = 16;
    /** Approximate number of points at which the flux of lights is measured, on all faces together. */
    private static final int FLUX_POINTS = 1 << 16;

    private final Faces faces;
    private final RadiosityBounds bounds;
    private final List<Light> lights;
    private final Map<Light, Sky> skies = new ConcurrentHashMap<>();

    public LightSources(Faces faces, RadiosityBounds bounds) {
        this.faces = faces;
        this.bounds = bounds;
        lights = faces.scene().lights();
    }

    public boolean isEmpty() {
        return lights.isEmpty();
    }

    /**
     * How closely a point looks at skies.
     *
     * @param tolerance irradiance that one ray may carry, relative to the mean, at least 0
     * @param mean      one per channel: mean irradiance, W/m²; empty: a ray may carry next to nothing
     * @param key       number from which the directions of rays follow
     */
    public record SkyRays(double tolerance, double[] mean, long key) {

        public static final SkyRays EXACT = new SkyRays(0, new double[0], 0);

        private Sky.Detail detail(Faces faces, int light) {
            double perRay = mean.length == 0 ? 0 : Double.POSITIVE_INFINITY;
            for (int c = 0; c < mean.length; c++) {
                double power = faces.power(light, c);
                perRay = power > 0 ? Math.min(perRay, tolerance * mean[c] / power) : perRay;
            }
            return new Sky.Detail(perRay, tolerance, Hash.mix(key, light));
        }
    }

    /** Adds the light of all sources to the irradiance of a vertex. */
    public void light(RadiosityNodes nodes, int v, SkyRays rays) {
        ReceivingPoints points = nodes.points();
        add(points.receivers(), 3 * v, points.plane(v), nodes.light().irradiance(), nodes.channels() * v, rays);
    }

    /**
     * Adds the irradiance that a point on a face receives from all sources.
     *
     * @param place x, y, z in the scene brought to size 1, 3 numbers from {@code at}; not modified
     * @param to    modified: irradiance, one per channel from {@code first}, W/m²
     */
    public void add(float[] place, int at, int face, double[] to, int first, SkyRays rays) {
        add(new Vec3(place[at], place[at + 1], place[at + 2]), faces.unitNormal(face), to, first, kind -> true, rays);
    }

    /**
     * Adds the irradiance that any point receives from all sources.
     *
     * @param x  the point, in the scene brought to size 1
     * @param n  normal of the receiving side, length 1
     * @param to modified: irradiance, one per channel from {@code first}, W/m²
     */
    public void add(Vec3 x, Vec3 n, double[] to, int first) {
        add(x, n, to, first, SkyRays.EXACT);
    }

    /** The same, looking at skies as closely as {@code rays} say. */
    public void add(Vec3 x, Vec3 n, double[] to, int first, SkyRays rays) {
        add(x, n, to, first, kind -> true, rays);
    }

    /** Adds the irradiance that a point receives from all sources but skies; {@code to} has one per channel, W/m². */
    public void addAllButSkies(Vec3 x, Vec3 n, double[] to) {
        add(x, n, to, 0, kind -> !kind.isSky(), SkyRays.EXACT);
    }

    /** Irradiance of a level place under skies everywhere as bright as in unit direction d: one per channel, W/m². */
    public double[] sky(Vec3 d) {
        double[] sum = new double[faces.channels()];
        for (int i = 0; i < lights.size(); i++) {
            double share = !lights.get(i).kind().isSky() ? 0 : luminance(lights.get(i), d);
            for (int c = 0; c < sum.length; c++) {
                sum[c] += share * faces.power(i, c);
            }
        }
        return sum;
    }

    /** Luminance of a sky in unit direction d; if it were the same everywhere, the irradiance of a level place. */
    double luminance(Light sky, Vec3 d) {
        return skies.computeIfAbsent(sky, Sky::new).towards(d);
    }

    private void add(Vec3 x, Vec3 n, double[] to, int first, Predicate<Light.Kind> which, SkyRays rays) {
        for (int i = 0; i < lights.size(); i++) {
            if (!which.test(lights.get(i).kind())) {
                continue;
            }
            double share = irradiance(lights.get(i), x, n, rays.detail(faces, i));
            for (int c = 0; c < faces.channels(); c++) {
                to[first + c] += share * faces.power(i, c);
            }
        }
    }

    /**
     * Flux of all sources but the sun and skies that arrives on all faces, one per channel, W. The flux is measured at
     * points spread evenly over the faces, so it does not depend on the mesh.
     */
    public double[] flux() {
        double[] flux = new double[faces.channels()];
        if (lights.stream().allMatch(light -> light.kind().isOutside())) {
            return flux;
        }
        double[] sum = new double[faces.channels()];
        for (int f = 0; f < faces.count(); f++) {
            Vec3 a = faces.unitCorner(f, 0);
            Vec3 ab = faces.unitCorner(f, 1).minus(a);
            Vec3 ac = faces.unitCorner(f, 2).minus(a);
            Vec3 n = faces.unitNormal(f);
            int points = (int) Math.max(1, Math.ceil(FLUX_POINTS * faces.area(f) / faces.area()));
            for (int i = 1; i <= points; i++) {
                double r = Math.sqrt(R2.u(i));
                double s = R2.v(i);
                add(a.plus(ab.times(r * (1 - s))).plus(ac.times(r * s)), n, sum, 0,
                        kind -> !kind.isOutside(), SkyRays.EXACT);
            }
            for (int c = 0; c < sum.length; c++) {
                flux[c] += sum[c] / points * faces.area(f) * faces.size() * faces.size();
                sum[c] = 0;
            }
        }
        return flux;
    }

    /** Irradiance at x with normal n, relative to the light's power. */
    double irradiance(Light light, Vec3 x, Vec3 n) {
        return irradiance(light, x, n, Sky.Detail.EXACT);
    }

    private double irradiance(Light light, Vec3 x, Vec3 n, Sky.Detail detail) {
        return switch (light.kind()) {
            case DISTANT -> distant(light, x, n);
            case POINT, SPOT -> light.luminaire().isPresent() ? luminaire(light, light.luminaire().get(), x, n)
                    : point(light, x, n);
            case AREA -> area(light, x, n);
            case SKY_UNIFORM, SKY_OVERCAST, SKY_CLEAR -> {
                RadiosityBounds.Blocker last = new RadiosityBounds.Blocker();
                yield skies.computeIfAbsent(light, Sky::new).irradiance(n, d -> bounds.isFree(x, d, last), detail);
            }
        };
    }

    private double distant(Light light, Vec3 x, Vec3 n) {
        Vec3 towards = light.direction().unit().times(-1);
        double cos = towards.dot(n);
        return cos > 0 && bounds.isFree(x, towards, new RadiosityBounds.Blocker()) ? cos : 0;
    }

    private double point(Light light, Vec3 x, Vec3 n) {
        Vec3 at = faces.unit(light.position());
        Vec3 towards = at.minus(x);
        double d = towards.length();
        double cos = towards.dot(n) / d;
        double range = light.range() / faces.size();
        if (!(cos > 0) || !sees(x, at)) {
            return 0;
        }
        double beam = light.kind() == Light.Kind.SPOT ? beam(light, -towards.dot(light.direction().unit()) / d) : 1;
        return beam * cos * range * range / (d * d);
    }

    /**
     * A luminaire is divided into parts so small that each is far away for its size, and shines as a point with the
     * luminaire's distribution (the five-times rule of photometry; here {@link #SMALL} times).
     */
    private double luminaire(Light light, Luminaire lamp, Vec3 x, Vec3 n) {
        Vec3 down = light.direction().unit();
        Vec3 zero = lamp.zero().minus(down.times(lamp.zero().dot(down))).unit();
        Vec3 across = zero.cross(down);
        Vec3 at = faces.unit(light.position());
        double range = light.range() / faces.size();
        double length = lamp.length() / faces.size();
        double width = lamp.width() / faces.size();
        double near = Math.max(at.minus(x).length(), Math.max(length, width) / 2);
        int along = points(length, near);
        int beside = points(width, near);
        double sum = 0;
        for (int i = 0; i < along * beside; i++) {
            Vec3 point = at.plus(zero.times(length * ((i % along + 0.5) / along - 0.5)))
                    .plus(across.times(width * ((i / along + 0.5) / beside - 0.5)));
            Vec3 away = x.minus(point);
            double square = away.dot(away);
            double cos = -away.dot(n) / Math.sqrt(square);
            double intensity = !(cos > 0) ? 0
                    : lamp.intensity().towards(away.dot(down), away.dot(zero), away.dot(across));
            sum += intensity > 0 && sees(x, point.plus(away.times(MOUNTED))) ? intensity * cos / square : 0;
        }
        return sum * range * range / (along * beside * lamp.intensity().max());
    }

    /** Number of points along an edge of this length; 1 for a luminaire without size, even at distance 0. */
    private static int points(double size, double distance) {
        return size == 0 ? 1 : (int) Math.max(1, Math.min(MOST_POINTS, Math.ceil(SMALL * size / distance)));
    }

    /** Relative intensity of a spot: 1 inside the cone, falling to 0 across the cone's soft edge. */
    private static double beam(Light light, double cos) {
        double angle = StrictMath.acos(Math.max(-1, Math.min(1, cos)));
        double inside = light.cone() - angle;
        return inside <= 0 ? 0 : inside >= light.edge() ? 1 : inside / light.edge();
    }

    private double area(Light light, Vec3 x, Vec3 n) {
        Vec3 at = faces.unit(light.position());
        Vec3 u = light.right().times(1 / faces.size());
        Vec3 v = light.up().times(1 / faces.size());
        if (u.cross(v).dot(light.direction()) < 0) {
            u = u.times(-1);
        }
        Vec3[] corner = {at.minus(u).minus(v), at.plus(u).minus(v), at.plus(u).plus(v), at.minus(u).plus(v)};
        double factor = x.minus(at).dot(light.direction()) <= 0 ? 0
                : ContourFactor.factor(x, n, corner);
        return factor == 0 ? 0 : factor * share(light, x, n, at, u, v);
    }

    /** Visible share of an area light with half edges u and v, weighted by cos cos / r^2; in [0, 1]. */
    private double share(Light light, Vec3 x, Vec3 n, Vec3 at, Vec3 u, Vec3 v) {
        double seen = 0;
        double all = 0;
        for (int i = 1; i <= SAMPLES; i++) {
            double s = 2 * R2.u(i) - 1;
            double t = 2 * R2.v(i) - 1;
            Vec3 y = at.plus(u.times(s)).plus(v.times(t));
            Vec3 d = y.minus(x);
            double k = Math.max(0, d.dot(n)) * Math.max(0, -d.dot(light.direction())) / (d.dot(d) * d.dot(d));
            all += k;
            seen += k > 0 && sees(x, y) ? k : 0;
        }
        return all == 0 ? 0 : seen / all;
    }

    private boolean sees(Vec3 x, Vec3 y) {
        return !bounds.blocked(x, y);
    }
}
