package radiosity.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import radiosity.scene.ImageMap.Wrap;
import radiosity.scene.Light;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.SparedBoxes;

/**
 * What a scene that needs little does not pay for: the Cornell box in grey, and the same with one thing more at a time
 * that has next to no influence on its light.
 */
final class Savings {

    private static final int PATCHES = 10_000;
    private static final int PIXELS = 64;
    /** Grey but for this, a channel is one too many. */
    private static final double OFF = 1e-3;
    private static final double FAINT = 1e-6;

    private Savings() { }

    /** @param box with two-sided and coloured surfaces or without */
    static void print(Scene box) {
        Scene grey = with(box, s -> new Surface(s.name(), grey(s.exitance()), grey(s.reflectance()), false));
        System.out.println("| scene | elements | CPU s | over grey | bytes per element | over grey |");
        System.out.println("|---|---|---|---|---|---|");
        Performance.Cost least = line("grey", grey, null);
        line("colours", with(grey, Savings::coloured), least);
        line("images", textured(with(grey, Savings::mapped)), least);
        line("a light", lit(grey), least);
        line("two-sided", with(grey, s -> new Surface(s.name(), s.exitance(), s.reflectance(), true)), least);
        System.out.println();
        SparedBoxes.print(List.of(RoomScenes.cube(RoomScenes.grey("wall", 0, 0.5)), grey));
    }

    private static Performance.Cost line(String name, Scene scene, Performance.Cost least) {
        try {
            Performance.Cost c = Performance.warm(scene, Performance.uniform(scene, PATCHES), 1);
            Performance.Cost base = least == null ? c : least;
            System.out.printf("| %s | %d | %.2f | %.2f | %.0f | %.2f |%n", name, c.elements(), c.cpu(),
                    c.cpu() / base.cpu(), c.bytes() / c.elements(),
                    c.bytes() / c.elements() / (base.bytes() / base.elements()));
            return c;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Rgb grey(Rgb colour) {
        return Rgb.grey((colour.r() + colour.g() + colour.b()) / 3);
    }

    private static Surface coloured(Surface s) {
        Rgb rho = s.reflectance();
        return new Surface(s.name(), s.exitance(), new Rgb(rho.r(), rho.g(), rho.b() * (1 - OFF)), false);
    }

    /** With an image that is the same everywhere. */
    private static Surface mapped(Surface s) {
        float[] rgb = new float[3 * PIXELS * PIXELS];
        Arrays.fill(rgb, (float) s.reflectance().r());
        return s.with(new Surface.Maps(Optional.empty(),
                Optional.of(new Raster(PIXELS, PIXELS, rgb, Wrap.REPEAT, Wrap.REPEAT, Rgb.BLACK))));
    }

    private static Scene with(Scene s, UnaryOperator<Surface> change) {
        return new Scene(s.name(), s.points(), s.corners(), s.surfaceOf(), s.surfaces().stream().map(change).toList(),
                s.lights(), s.camera());
    }

    private static Scene textured(Scene s) {
        float[] places = new float[6 * s.triangles()];
        for (int i = 0; i < places.length; i++) {
            places[i] = i % 6 / 5f;
        }
        return new Scene(s.name(), s.points(), s.corners(), s.surfaceOf(), s.surfaces(), s.lights(), s.camera(),
                places);
    }

    private static Vec3 middle(Scene s) {
        Vec3 sum = Vec3.ZERO;
        for (int i = 0; i < 3 * s.triangles(); i++) {
            sum = sum.plus(s.corner(i / 3, i % 3));
        }
        return sum.times(1.0 / (3 * s.triangles()));
    }

    private static Scene lit(Scene s) {
        Light light = new Light("light", Light.Kind.POINT, Rgb.grey(FAINT), middle(s),
                new Vec3(0, -1, 0), Vec3.ZERO, Vec3.ZERO, 1, 0, 0);
        return new Scene(s.name(), s.points(), s.corners(), s.surfaceOf(), s.surfaces(), List.of(light), s.camera());
    }
}
