package radiosity.formfactor;

import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.scene.Lamp;
import radiosity.scene.Light;
import radiosity.scene.Vec3;
import radiosity.util.Frame;
import radiosity.util.R2;
import radiosity.visibility.RadiosityBounds;

/**
 * Finds lamps whose light arrives nowhere by rays: luminaires inside a slab, and surfaces that emit towards the back of
 * what they lie on, and the sun and skies outside of closed rooms. Lights without power are not looked at.
 */
public final class UnseenLamps {

    /** Most rays per lamp, until one arrives. */
    private static final int RAYS = 1 << 13;
    /** Most rays to the sun or a sky, until one is free: a small window is seen from few places. */
    private static final int RAYS_OUT = 1 << 17;
    /** Share of a face along its edges from which no ray begins: there rays could slip between two faces. */
    private static final double INSET = 1e-3;
    /** Most faces of a surface from which rays begin. */
    private static final int MOST_FACES = 256;
    /** Distance from a lamp at which a ray begins, and from the place that it meets, in units of the scene's size. */
    private static final double MOUNTED = 1e-4;

    private final Faces faces;
    private final RadiosityBounds bounds;
    private final float[] front;
    private final EscapingLight escaping;
    private final LightSources lights;

    public UnseenLamps(Faces faces, RadiosityBounds bounds, EscapingLight escaping) {
        this.faces = faces;
        this.bounds = bounds;
        front = faces.fronts();
        this.escaping = escaping;
        lights = new LightSources(faces, bounds);
    }

    /** The lamps of the scene none of whose rays arrives on a visible side. */
    public List<Lamp> list() {
        return faces.scene().lamps().stream().filter(lamp -> lamp.surface() ? !isSeen(lamp.index())
                : !isSeen(faces.scene().lights().get(lamp.index()))).toList();
    }

    private boolean isSeen(int surface) {
        int[] some = IntStream.range(0, faces.count())
                .filter(f -> faces.scene().surfaceOf()[faces.triangle(f)] == surface).toArray();
        int step = Math.max(1, some.length / MOST_FACES);
        int rays = Math.max(1, RAYS * step / Math.max(1, some.length));
        for (int i = 0; i < some.length; i += step) {
            for (int ray = 1; ray <= rays; ray++) {
                double[] at = Frame.inCircle(R2.u(ray), R2.v(ray));
                if (!escaping.escapes(point(some[i], i + ray), some[i], at[0], at[1])) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Point of a number on a face but not on its edges, x, y, z in the scene brought to size 1. */
    private float[] point(int face, int number) {
        double r = 2 / 3.0 + (1 - INSET) * (Math.sqrt(R2.v(number)) - 2 / 3.0);
        double s = 0.5 + (1 - INSET) * (R2.u(number) - 0.5);
        float[] point = new float[3];
        for (int a = 0; a < 3; a++) {
            point[a] = (float) ((1 - r) * faces.corner(face, 0, a) + r * (1 - s) * faces.corner(face, 1, a)
                    + r * s * faces.corner(face, 2, a));
        }
        return point;
    }

    private boolean isSeen(Light light) {
        if (light.power().max() == 0) {
            return true;
        }
        return light.kind().isOutside() ? isSeenOutside(light)
                : IntStream.rangeClosed(1, RAYS).anyMatch(i -> arrives(light, direction(light, i)));
    }

    /** Whether rays from points spread evenly over the faces find a light that is outside. */
    private boolean isSeenOutside(Light light) {
        double due = 0;
        int ray = 0;
        for (int f = 0; f < faces.count(); f++) {
            Vec3 n = faces.unitNormal(f);
            for (due += RAYS_OUT * faces.area(f) / faces.area(); due >= 1; due--) {
                float[] place = point(f, ++ray);
                if (isSeenOutside(light, new Vec3(place[0], place[1], place[2]), n, ray)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isSeenOutside(Light light, Vec3 x, Vec3 n, int ray) {
        if (!light.kind().isSky()) {
            return lights.irradiance(light, x, n) > 0;
        }
        Vec3 d = Frame.of(n).diffuse(R2.u(ray), R2.v(ray));
        return lights.luminance(light, d) > 0 && bounds.isFree(x, d, new RadiosityBounds.Blocker());
    }

    /** Direction of a ray, in the cone of a spot light, in any direction from other lights. */
    private static Vec3 direction(Light light, int number) {
        Vec3 axis = light.kind() == Light.Kind.SPOT ? light.direction().unit() : new Vec3(0, 1, 0);
        double low = light.kind() == Light.Kind.SPOT ? StrictMath.cos(light.cone()) : -1;
        double cos = 1 - R2.u(number) * (1 - low);
        double[] at = Frame.inCircle(1 - cos * cos, R2.v(number));
        return Frame.of(axis).vector(at[0], at[1], cos);
    }

    /** Whether a ray from a lamp arrives on a visible side that the lamp lights. */
    private boolean arrives(Light light, Vec3 d) {
        Vec3 from = faces.unit(light.position()).plus(d.times(MOUNTED));
        float[] hit = new float[3];
        int t = escaping.arrival(floats(from), floats(d), hit);
        if (t < 0) {
            return false;
        }
        Vec3 normal = new Vec3(front[3 * t], front[3 * t + 1], front[3 * t + 2]);
        Vec3 n = normal.length() == 0 ? d.times(-1) : normal; // without a normal the triangle shows both sides
        return lights.irradiance(light, from.plus(d.times(hit[0])).plus(n.times(MOUNTED)), n) > 0;
    }

    private static float[] floats(Vec3 v) {
        float[] floats = new float[3];
        v.write(floats, 0);
        return floats;
    }
}
