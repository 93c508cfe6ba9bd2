package radiosity.cli.render;

import java.util.Optional;
import java.util.function.Consumer;
import radiosity.scene.Light;
import radiosity.scene.Luminaire;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;
import radiosity.visibility.RadiosityBounds;

/** Warns of luminaires that hang outside the scene and light no surface: mostly their unit or axes are wrong. */
public final class LuminaireCheck {

    /** Number of points on all surfaces, by area, from which a luminaire is looked for; at least 1 per triangle. */
    private static final int POINTS = 4096;
    /**
     * Steps of a sequence of points in the unit square (M. Roberts, The unreasonable effectiveness of quasirandom
     * sequences, 2018).
     */
    private static final double STEP_U = 0.7548776662466927;
    private static final double STEP_V = 0.5698402909980532;

    private final Scene scene;
    private final Consumer<String> warnings;

    public LuminaireCheck(Scene scene, Consumer<String> warnings) {
        this.scene = scene;
        this.warnings = warnings;
    }

    /** Warns of each luminaire outside the box around the scene that no point on a surface sees shining. */
    public void outside() {
        Aabb box = Aabb.of(scene.points());
        RadiosityBounds bounds = null;
        for (Light light : scene.lights()) {
            Optional<Luminaire> luminaire = light.luminaire();
            if (luminaire.isPresent() && isOutside(light.position(), box)) {
                bounds = bounds == null ? bounds(box) : bounds;
                if (!lights(light, luminaire.get(), box, bounds)) {
                    warnings.accept(scene.name() + ": expected luminaires whose light meets a surface, got "
                            + light.name() + ", which is outside the scene and whose light meets none");
                }
            }
        }
    }

    private static boolean isOutside(Vec3 p, Aabb box) {
        Vec3 far = p.minus(box.centre());
        Vec3 half = box.extent().times(0.5);
        return Math.abs(far.x()) > half.x() || Math.abs(far.y()) > half.y() || Math.abs(far.z()) > half.z();
    }

    private RadiosityBounds bounds(Aabb box) {
        float[] corners = new float[9 * scene.triangles()];
        for (int i = 0; i < 3 * scene.triangles(); i++) {
            Vec3 corner = unit(scene.corner(i / 3, i % 3), box);
            corners[3 * i] = (float) corner.x();
            corners[3 * i + 1] = (float) corner.y();
            corners[3 * i + 2] = (float) corner.z();
        }
        return new RadiosityBounds(corners);
    }

    /** The place itself or, far away, a point outside the box on the way there: long segments have wide ends. */
    private static Vec3 beyond(Vec3 x, Vec3 place, Aabb box) {
        Vec3 way = place.minus(x);
        double far = 2 * box.diagonal();
        return way.length() <= far ? place : x.plus(way.times(far / way.length()));
    }

    /** A point in the coordinates in which the scene is of size 1 around the origin. */
    private static Vec3 unit(Vec3 p, Aabb box) {
        return p.minus(box.centre()).times(1 / box.diagonal());
    }

    private boolean lights(Light light, Luminaire lamp, Aabb box, RadiosityBounds bounds) {
        Vec3 down = light.direction().unit();
        Vec3 zero = lamp.zero().minus(down.times(lamp.zero().dot(down))).unit();
        Vec3 across = zero.cross(down);
        double perArea = POINTS / scene.area();
        for (int t = 0; t < scene.triangles(); t++) {
            Vec3 a = scene.corner(t, 0);
            int points = (int) Math.max(1, Math.ceil(perArea * scene.area(t)));
            for (int i = 1; i <= points; i++) {
                double r = Math.sqrt(i * STEP_U % 1);
                double s = i * STEP_V % 1;
                Vec3 x = a.plus(scene.corner(t, 1).minus(a).times(r * (1 - s)))
                        .plus(scene.corner(t, 2).minus(a).times(r * s));
                Vec3 away = x.minus(light.position());
                boolean faces = scene.surface(t).twoSided() || away.dot(scene.cross(t)) < 0;
                if (faces && lamp.intensity().towards(away.dot(down), away.dot(zero), away.dot(across)) > 0
                        && !bounds.blocked(unit(x, box), unit(beyond(x, light.position(), box), box))) {
                    return true;
                }
            }
        }
        return false;
    }
}
