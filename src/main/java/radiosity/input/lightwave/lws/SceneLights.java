package radiosity.input.lightwave.lws;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import radiosity.input.file.Diagnostics;
import radiosity.scene.Affine;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;

/** Makes the lights of a scene from their descriptions in its file. */
public final class SceneLights {

    private final SceneDescription scene;
    private final Placement placement;
    private final Motion.Instant instant;
    private final Diagnostics notes;
    private final Set<String> replaced;

    /** @param replaced names of lights that luminaires replace, which take their places and colours, not intensities */
    public SceneLights(SceneDescription scene, Placement placement, Motion.Instant instant, Diagnostics notes,
                       Set<String> replaced) {
        this.scene = scene;
        this.placement = placement;
        this.instant = instant;
        this.notes = notes;
        this.replaced = replaced;
    }

    /** All lights with a power above 0; {@code SceneAssembly} decides by the options whether they are used. */
    public List<Light> lights() {
        List<Light> lights = new ArrayList<>();
        for (SceneItem item : scene.items(SceneItem.Kind.LIGHT)) {
            Rgb power = power(item);
            if (power.max() > 0 && power.isFinite()) {
                light(item, power, lights);
            }
        }
        return lights;
    }

    private Rgb power(SceneItem item) {
        double scale = scene.version <= 2 ? 1 / 255.0 : 1;
        double[] colour = item.numbers("LightColor", instant, 1 / scale, 1 / scale, 1 / scale);
        double intensity = Math.max(0, item.number(item.either("LightIntensity", "LgtIntensity"), instant, 1));
        if (intensity == 0 && replaced.contains(item.text("LightName"))) {
            intensity = 1;
        }
        return new Rgb(Math.max(0, colour[0]), Math.max(0, colour[1]), Math.max(0, colour[2])).times(scale * intensity);
    }

    private void light(SceneItem item, Rgb power, List<Light> lights) {
        int type = type(item);
        switch (type) {
            case 0 -> add(item, Light.Kind.DISTANT, power, lights);
            case 1 -> add(item, Light.Kind.POINT, power, lights);
            case 2 -> add(item, Light.Kind.SPOT, power, lights);
            case 4 -> add(item, Light.Kind.AREA, power.times(Math.PI), lights);
            case 3 -> {
                notes.note(item.place(), "linear lights are taken as point lights at their middle");
                add(item, Light.Kind.POINT, power, lights);
            }
            default -> notes.note(item.place(), "lights of a kind that is not known are left out",
                    String.valueOf(type));
        }
    }

    /** Type of a light; a plug-in's name takes precedence, as later versions write LightType for older ones only. */
    private int type(SceneItem item) {
        String name = item.text("LightHandler").toLowerCase(Locale.ROOT).replace("\"", "").replace("light", "").trim();
        return switch (name) {
            case "distant" -> 0;
            case "point", "spherical", "photometric" -> 1;
            case "spot" -> 2;
            case "linear" -> 3;
            case "area" -> 4;
            case "dome" -> 5;
            default -> (int) item.number("LightType", instant, 0);
        };
    }

    private void add(SceneItem item, Light.Kind kind, Rgb power, List<Light> lights) {
        Affine world = placement.world(item);
        boolean isSomewhere = power.isFinite();
        for (double m : world.m()) {
            isSomewhere &= Double.isFinite(m);
        }
        double length = right(world.direction(0, 0, 1)).length();
        if (isSomewhere && length > 0 && Double.isFinite(length)) {
            lights.add(make(item, kind, power, world));
        } else {
            notes.note(item.place(), "lights are left out that are nowhere, or scaled to nothing");
        }
    }

    private Light make(SceneItem item, Light.Kind kind, Rgb power, Affine world) {
        double range = item.number("LightRange", instant, 1);
        double coneAngle = item.number(item.either("LightConeAngle", "ConeAngle"), instant,
                scene.version <= 2 ? 30 : Math.toRadians(30));
        double edgeAngle = item.number(item.either("LightEdgeAngle", "EdgeAngle"), instant,
                scene.version <= 2 ? 5 : Math.toRadians(5));
        boolean area = kind == Light.Kind.AREA;
        return new Light(item.text("LightName"), kind, power,
                new Vec3(world.m()[3], world.m()[7], 0 - world.m()[11]), right(world.direction(0, 0, 1)).unit(),
                area ? right(world.direction(0.5, 0, 0)) : right(world.direction(1, 0, 0)).unit(),
                area ? right(world.direction(0, 0.5, 0)) : Vec3.ZERO,
                range > 0 ? range : 1, angle(coneAngle), angle(edgeAngle));
    }

    /**
     * An angle in radians. Scenes of versions 1 and 2 have degrees, later ones radians; more than pi cannot be radians,
     * as the angles of a spot light are measured from its axis.
     */
    private double angle(double written) {
        double angle = scene.version <= 2 || written > Math.PI ? Math.toRadians(written) : written;
        return Math.max(0, Math.min(Math.PI, angle));
    }

    /** The direction in the scene's right-handed space of a left-handed direction. */
    static Vec3 right(double[] d) {
        return new Vec3(d[0], d[1], 0 - d[2]);
    }
}
