package radiosity.torture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Where the light of a scene file went, counted from its radiosity, irradiance, areas and reflectances alone.
 *
 * <p>Absorbed flux is the integral of (1 - reflectance) times irradiance, which is linear over every triangle. Escaped
 * flux is what leaves a surface and then meets nothing or the back of something: found by rays of this class, from
 * points distributed like radiosity and with directions distributed like the cosine. Both together are what was
 * emitted, less what is unshot. A face that stands in a body or lies against one shows light on the whole of its
 * triangles, where none arrives on the covered part: what would be absorbed there is found by points distributed like
 * absorbed flux, from which all rays meet backs.
 */
final class Energy {

    /** More than this share of what was emitted is not found absorbed or escaped where no energy is gained. */
    static final double MOST = 1.002;
    /** No radiosity of a finished render is lower, relative to the mean. */
    static final double LOWEST = -1e-6;
    private static final int MOST_TESTS = 120_000_000;
    private static final int MOST_RAYS = 20_000;
    /** So many rays from a covered point meet backs. */
    private static final int COVERED = 12;

    /** W per channel. */
    final double[] emitted = new double[3];
    final double[] absorbed = new double[3];
    final double[] escaped = new double[3];
    /** Standard deviation of what escaped, W per channel. */
    final double[] deviation = new double[3];
    /** Flux counted in {@link #absorbed} on covered parts, W per channel; and its standard deviation. */
    final double[] covered = new double[3];
    final double[] coveredDeviation = new double[3];
    private final List<double[]> triangles = new ArrayList<>();
    private final List<double[]> light = new ArrayList<>();
    /** Flux that is absorbed, W per channel of each triangle. */
    private final List<double[]> taken = new ArrayList<>();
    /** Sum of |unshot flux| over elements and channels, W. */
    private final double unshot;
    private double size;
    private double area;
    private double lowest = Double.POSITIVE_INFINITY;

    /** @param lightFlux emitted by what is no surface, W per channel */
    Energy(LightFile file, double lightFlux, long seed) {
        Arrays.fill(emitted, lightFlux);
        unshot = file.radiosity.path("unshotFlux").asDouble();
        for (LightFile.Mesh mesh : file.meshes) {
            for (int i = 0; i < mesh.indices().length; i += 3) {
                add(mesh, i);
            }
        }
        count(light, escaped, deviation, 1, new Dice(seed));
        count(taken, covered, coveredDeviation, COVERED, new Dice(seed));
    }

    private void add(LightFile.Mesh mesh, int first) {
        double[] t = new double[9];
        for (int k = 0; k < 9; k++) {
            t[k] = mesh.positions()[3 * mesh.indices()[first + k / 3] + k % 3];
        }
        double area = length(normal(t)) / 2;
        this.area += area;
        double[] leaving = new double[3];
        double[] staying = new double[3];
        boolean painted = mesh.attributes().containsKey("_REFLECTANCE");
        for (int c = 0; c < 3; c++) {
            for (int k = 0; k < 3; k++) {
                int v = mesh.indices()[first + k];
                double arriving = mesh.irradiance()[3 * v + c];
                double reflectance = mesh.reflectance(v, c);
                double radiosity = mesh.radiosity()[3 * v + c];
                lowest = Math.min(lowest, radiosity);
                double exitance = painted && mesh.exitance()[c] > 0 ? Math.max(0, radiosity - reflectance * arriving)
                        : mesh.exitance()[c];
                staying[c] += area / 3 * (1 - reflectance) * arriving;
                emitted[c] += area / 3 * exitance;
                leaving[c] += area / 3 * radiosity;
            }
            leaving[c] = Math.max(0, leaving[c]);
            absorbed[c] += staying[c];
            staying[c] = Math.max(0, staying[c]);
        }
        triangles.add(t);
        light.add(leaving);
        taken.add(staying);
        for (double x : t) {
            size = Math.max(size, Math.abs(x));
        }
    }

    /**
     * Sums the flux at points from which a number of rays all end where no light comes from.
     *
     * @param flux      distribution of the points: W per channel of each triangle
     * @param found     modified: adds the flux of these points, W per channel
     * @param deviation modified: set to the standard deviation of that, W per channel
     */
    private void count(List<double[]> flux, double[] found, double[] deviation, int rays, Dice dice) {
        double[] upTo = new double[flux.size() + 1];
        for (int i = 0; i < flux.size(); i++) {
            upTo[i + 1] = upTo[i] + flux.get(i)[0] + flux.get(i)[1] + flux.get(i)[2];
        }
        double total = upTo[flux.size()];
        int points = Math.min(MOST_RAYS, MOST_TESTS / Math.max(1, triangles.size()));
        double[] squares = new double[3];
        for (int n = 0; n < points && total > 0; n++) {
            int from = Arrays.binarySearch(upTo, (n + dice.between(0, 1)) / points * total);
            from = Math.min(flux.size() - 1, from < 0 ? -from - 2 : from);
            if (!endsInTheDark(triangles.get(from), rays, dice)) {
                continue;
            }
            double sum = upTo[from + 1] - upTo[from];
            for (int c = 0; c < 3; c++) {
                double its = sum > 0 ? flux.get(from)[c] / sum * total / points : 0;
                found[c] += its;
                squares[c] += its * its;
            }
        }
        for (int c = 0; c < 3; c++) {
            deviation[c] = Math.sqrt(squares[c]);
        }
    }

    /** Whether rays from a point of a triangle all leave the scene or meet backs; of several rays, whether backs. */
    private boolean endsInTheDark(double[] t, int rays, Dice dice) {
        double u = Math.sqrt(dice.between(0, 1));
        double v = dice.between(0, 1);
        double[] n = normal(t);
        double scale = 1 / length(n);
        double[] origin = new double[3];
        for (int k = 0; k < 3; k++) {
            n[k] *= scale;
            origin[k] = (1 - u) * t[k] + u * (1 - v) * t[3 + k] + u * v * t[6 + k] + 1e-6 * size * n[k];
        }
        boolean dark = true;
        for (int ray = 0; ray < rays && dark; ray++) {
            dark = meetsNoFront(origin, direction(n, dice), rays == 1);
        }
        return dark;
    }

    /** Whether a ray meets the back of something first, or nothing, where that counts. */
    private boolean meetsNoFront(double[] origin, double[] direction, boolean orNothing) {
        double front = Double.MAX_VALUE;
        double back = Double.MAX_VALUE;
        for (double[] other : triangles) {
            double at = hit(other, origin, direction);
            if (at > 0) {
                front = Math.min(front, at);
            } else if (at < 0) {
                back = Math.min(back, -at);
            }
        }
        return front == Double.MAX_VALUE ? orNothing || back < front : back < front - 1e-5 * size;
    }

    /** About a normal, distributed like the cosine: a point of the sphere that touches the surface. */
    private static double[] direction(double[] n, Dice dice) {
        double z = dice.between(-1, 1);
        double angle = dice.between(0, 2 * StrictMath.PI);
        double r = Math.sqrt(Math.max(0, 1 - z * z));
        double[] d = {n[0] + r * StrictMath.cos(angle), n[1] + r * StrictMath.sin(angle), n[2] + z};
        return length(d) > 1e-9 ? d : n.clone();
    }

    /** How far away a triangle is hit: above 0 its visible side, below 0 its back, 0 not at all. */
    private static double hit(double[] t, double[] o, double[] d) {
        double[] a = {t[3] - t[0], t[4] - t[1], t[5] - t[2]};
        double[] b = {t[6] - t[0], t[7] - t[1], t[8] - t[2]};
        double[] p = cross(d, b);
        double det = dot(a, p);
        if (det == 0) {
            return 0;
        }
        double[] s = {o[0] - t[0], o[1] - t[1], o[2] - t[2]};
        double u = dot(s, p) / det;
        double[] q = cross(s, a);
        double v = dot(d, q) / det;
        double at = dot(b, q) / det;
        boolean inside = u > -1e-6 && v > -1e-6 && u + v < 1 + 1e-6 && at > 0;
        return inside ? det > 0 ? at : -at : 0;
    }

    private static double[] normal(double[] t) {
        return cross(new double[] {t[3] - t[0], t[4] - t[1], t[5] - t[2]},
                new double[] {t[6] - t[0], t[7] - t[1], t[8] - t[2]});
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double length(double[] a) {
        return Math.sqrt(dot(a, a));
    }

    /** The lowest radiosity, relative to the mean of all surfaces and channels; 0 where all is dark. */
    double lowest() {
        double sum = light.stream().mapToDouble(flux -> flux[0] + flux[1] + flux[2]).sum();
        return sum > 0 ? lowest / (sum / (3 * area)) : 0;
    }

    /**
     * The largest share of a channel's emitted flux that was certainly absorbed or escaped: by three deviations of what
     * escaped and of what is covered, and less what is unshot, as light that is predicted is shot before it is there.
     */
    double found() {
        double most = 0;
        for (int c = 0; c < 3; c++) {
            double flux = absorbed[c] - covered[c] - 3 * coveredDeviation[c]
                    + Math.max(0, escaped[c] - 3 * deviation[c]) - unshot;
            most = Math.max(most, emitted[c] > 0 ? flux / emitted[c] : flux > 0 ? Double.POSITIVE_INFINITY : 0);
        }
        return most;
    }
}
