package radiosity.output.grid;

import java.util.Arrays;
import radiosity.formfactor.ContourFactor;
import radiosity.formfactor.LightSources;
import radiosity.mesh.face.Faces;
import radiosity.output.points.Points;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Frame;
import radiosity.util.R2;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;

/**
 * Calculates the light that arrives at points in the air, where a light meter would be held.
 *
 * <p>Emitted light is the factor of the contour formula (Lambert) times the fraction of rays to the lamp that are free.
 * Reflected light is gathered by rays uniform in the circle below the hemisphere (W. Nusselt, 1928), each of which
 * finds the radiosity at its end.
 */
final class FreeIrradiance {

    /** Number of rays along each side of the square that is mapped to the circle. */
    private static final int SIDE = 64;
    /**
     * Number of rays to a lamp that fills the hemisphere; in proportion to the form factor, at least one, to others.
     */
    private static final int LAMP_RAYS = 1024;
    /** Number of times that a triangle is divided whose exitance an image varies: into 256 parts. */
    private static final int IMAGE_LEVELS = 4;

    private final Scene scene;
    private final Points points;
    private final Faces faces;
    private final RadiosityBounds bounds;
    private final Solids solids;
    private final LightSources lights;

    FreeIrradiance(Solution solution, Points points) {
        scene = solution.scene();
        this.points = points;
        faces = new Faces(scene);
        bounds = new RadiosityBounds(faces.occluders());
        solids = new Solids(bounds, faces.fronts());
        lights = new LightSources(faces, bounds);
    }

    /**
     * Irradiance at a point on the side of a unit normal, W/m²; NaN inside a solid, or if no visible side is behind.
     */
    Rgb at(Vec3 point, Vec3 n) {
        Vec3 x = faces.unit(point);
        if (solids.hold(x, n) || look(x, n.times(-1), false) == null) {
            return Rgb.grey(Double.NaN);
        }
        double[] direct = new double[faces.channels()];
        lights.add(x, n, direct, 0);
        Rgb sum = Rgb.of(direct);
        for (int t = 0; t < scene.triangles(); t++) {
            if (scene.surface(t).emits()) {
                sum = sum.plus(emitted(t, 0, x, n));
                sum = scene.surface(t).twoSided() ? sum.plus(emitted(t, 1, x, n)) : sum;
            }
        }
        return sum.plus(reflected(x, n));
    }

    private Rgb reflected(Vec3 x, Vec3 n) {
        Frame frame = Frame.of(n);
        Rgb sum = Rgb.BLACK;
        for (int i = 0; i < SIDE * SIDE; i++) {
            Rgb light = look(x, frame.diffuse((i / SIDE + 0.5) / SIDE, (i % SIDE + R2.u(i / SIDE + 1)) / SIDE), true);
            sum = light == null ? sum : sum.plus(light);
        }
        return sum.times(1.0 / (SIDE * SIDE));
    }

    /**
     * The reflected radiosity that a ray finds, W/m².
     *
     * @param valued false if only the existence of a surface is asked for; the result then is black
     * @return null if the ray meets nothing, or the back of a one-sided surface
     */
    private Rgb look(Vec3 x, Vec3 d, boolean valued) {
        float[] hit = new float[3];
        int t = bounds.nearestFront(x, d, RadiosityBounds.ACROSS, true, hit);
        if (t < 0 || solids.leaves(t, d)) {
            return null;
        }
        if (!valued || scene.material(t, scene.corner(t, 0)).reflectance().max() == 0 && !scene.isMapped(t)) {
            return Rgb.BLACK;
        }
        Vec3 at = scene.corner(t, 0).times(1 - (double) hit[1] - hit[2]).plus(scene.corner(t, 1).times(hit[1]))
                .plus(scene.corner(t, 2).times(hit[2]));
        Vec3 normal = scene.cross(t).unit();
        Rgb irradiance = points.at(at, normal.dot(d) <= 0 ? normal : normal.times(-1)).irradiance();
        return Double.isNaN(irradiance.r()) ? Rgb.BLACK : irradiance.times(scene.material(t, at).reflectance());
    }

    /** Irradiance from the emitted light of one side of a triangle, 0 for the front or 1 for the back, W/m². */
    private Rgb emitted(int t, int side, Vec3 x, Vec3 n) {
        Vec3[] corners = {scene.corner(t, 0), scene.corner(t, 1 + side), scene.corner(t, 2 - side)};
        return emitted(t, corners, scene.isMapped(t) ? IMAGE_LEVELS : 0, x, n);
    }

    /**
     * Irradiance from a part of a triangle.
     *
     * @param levels number of times that the part is divided into four before its mean exitance is taken
     */
    private Rgb emitted(int t, Vec3[] corners, int levels, Vec3 x, Vec3 n) {
        if (levels == 0) {
            double factor = factor(corners, x, n);
            return factor > 0 ? scene.meanMaterial(t, corners[0], corners[1], corners[2]).exitance().times(factor)
                    : Rgb.BLACK;
        }
        Vec3[] middles = new Vec3[3];
        Arrays.setAll(middles, k -> corners[(k + 1) % 3].plus(corners[(k + 2) % 3]).times(0.5));
        Rgb sum = emitted(t, middles, levels - 1, x, n);
        for (int k = 0; k < 3; k++) {
            Vec3[] child = {corners[k], middles[(k + 2) % 3], middles[(k + 1) % 3]};
            sum = sum.plus(emitted(t, child, levels - 1, x, n));
        }
        return sum;
    }

    /** Form factor of the free part of a triangle with these corners, counter-clockwise seen from its visible side. */
    private double factor(Vec3[] corners, Vec3 x, Vec3 n) {
        Vec3[] c = {faces.unit(corners[0]), faces.unit(corners[1]), faces.unit(corners[2])};
        double factor = ContourFactor.factor(x, n, c);
        if (!(factor > 0)) {
            return 0;
        }
        Vec3 normal = c[1].minus(c[0]).cross(c[2].minus(c[0]));
        int rays = (int) Math.max(1, Math.ceil(factor * LAMP_RAYS));
        double all = 0;
        double free = 0;
        for (int i = 1; i <= rays; i++) {
            double r = Math.sqrt(R2.u(i));
            double s = R2.v(i);
            Vec3 y = c[0].times(1 - r).plus(c[1].times(r * (1 - s))).plus(c[2].times(r * s));
            Vec3 d = y.minus(x);
            double kernel = Math.max(0, d.dot(n)) * Math.max(0, -d.dot(normal)) / (d.dot(d) * d.dot(d));
            Vec3 end = y.minus(d.times(RadiosityBounds.LIFT / d.length()));
            all += kernel;
            free += kernel > 0 && !bounds.blocked(x, end) ? kernel : 0;
        }
        return all == 0 ? 0 : factor * free / all;
    }
}
