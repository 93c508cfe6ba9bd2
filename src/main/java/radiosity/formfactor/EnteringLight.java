package radiosity.formfactor;

import radiosity.mesh.face.Faces;
import radiosity.scene.Light;
import radiosity.scene.Vec3;
import radiosity.util.Frame;
import radiosity.visibility.RadiosityBounds;

/**
 * Finds by rays how much light of the sun and of skies arrives on visible sides. Parallel rays cover the rectangle that
 * holds the scene as it is seen from where they come from; those of a sky come from all directions.
 */
public final class EnteringLight {

    /** Numbers of rays: those of the sun differ in their beginnings only, those of a sky in their directions, too. */
    private static final int SUN_RAYS = 1 << 18;
    private static final int SKY_RAYS = 1 << 20;
    /**
     * The multiples of the first four powers of this number are spread evenly in four dimensions (M. Roberts, The
     * unreasonable effectiveness of quasirandom sequences, 2018); 1 over the root of x^5 = x + 1.
     */
    private static final double STEP = 1 / 1.1673039782614187;
    /** Distance from the middle of the scene at which rays begin, in units of the scene's size. */
    private static final double AWAY = 2;
    /**
     * Distance between a ray and the two rays that confirm it, in units of the scene's size: by rounding, a ray may
     * pass between two triangles that have an edge in common, and stand for more light than all lamps of a closed room.
     */
    private static final double BESIDE = 1e-5;

    private final Faces faces;
    private final RadiosityBounds bounds;
    private final LightSources lights;
    private final float[] front;
    /** Half the extents of the scene, in units of its size. */
    private final double[] extent = new double[3];

    public EnteringLight(Faces faces, RadiosityBounds bounds) {
        this.faces = faces;
        this.bounds = bounds;
        lights = new LightSources(faces, bounds);
        front = faces.fronts();
        for (int i = 0; i < 9 * faces.count(); i++) {
            extent[i % 3] = Math.max(extent[i % 3], Math.abs(faces.corner(i / 9, i / 3 % 3, i % 3)));
        }
    }

    /**
     * Flux that arrives, one per channel, W; the same numbers for the same scene.
     *
     * @param part part of the usual number of rays that is cast, in (0, 1]
     */
    public double[] flux(double part) {
        double[] flux = new double[faces.channels()];
        for (int light = 0; light < faces.scene().lights().size(); light++) {
            Light from = faces.scene().lights().get(light);
            double arrives = from.kind().isSky() ? sky(from, (int) (part * SKY_RAYS))
                    : from.kind().isOutside() ? sun(from, (int) (part * SUN_RAYS)) : 0;
            for (int c = 0; c < flux.length; c++) {
                flux[c] += arrives * faces.power(light, c) * faces.size() * faces.size();
            }
        }
        return flux;
    }

    /** Area at right angles to the sun whose light arrives, in squared units of the scene's size. */
    private double sun(Light light, int rays) {
        Vec3 towards = light.direction().unit().times(-1);
        double sum = 0;
        for (int i = 1; i <= rays; i++) {
            sum += area(towards, i);
        }
        return sum / rays;
    }

    /** The same of a sky, relative to the irradiance of a level place in the open. */
    private double sky(Light light, int rays) {
        Frame frame = Frame.of(light.up());
        double sum = 0;
        for (int i = 1; i <= rays; i++) {
            double height = fraction(i * STEP * STEP * STEP);
            double[] level = Frame.inCircle(1 - height * height, fraction(i * STEP * STEP * STEP * STEP));
            Vec3 towards = frame.vector(level[0], level[1], height);
            // irradiance is 1/pi of the luminance over all directions, of which there are 2 pi
            sum += 2 * lights.luminance(light, towards) * area(towards, i);
        }
        return sum / rays;
    }

    /** Area of the rectangle at right angles to a direction where a ray of light arrives on a visible side, else 0. */
    private double area(Vec3 towards, int number) {
        Vec3 u = towards.perpendicular();
        Vec3 v = towards.cross(u);
        double width = 2 * half(u);
        double height = 2 * half(v);
        Vec3 from = towards.times(AWAY).plus(u.times(width * (fraction(number * STEP) - 0.5)))
                .plus(v.times(height * (fraction(number * STEP * STEP) - 0.5)));
        boolean arrives = arrives(from, towards) && arrives(from.plus(u.times(BESIDE)), towards)
                && arrives(from.plus(v.times(BESIDE)), towards);
        return arrives ? width * height : 0;
    }

    private boolean arrives(Vec3 from, Vec3 towards) {
        int t = bounds.nearestFront(from, towards.times(-1), RadiosityBounds.ACROSS, true, new float[3]);
        return t >= 0
                && front[3 * t] * towards.x() + front[3 * t + 1] * towards.y() + front[3 * t + 2] * towards.z() >= 0;
    }

    private static double fraction(double x) {
        return x - Math.floor(x);
    }

    /** Half the width of the scene along a unit vector. */
    private double half(Vec3 along) {
        return Math.abs(along.x()) * extent[0] + Math.abs(along.y()) * extent[1] + Math.abs(along.z()) * extent[2];
    }
}
