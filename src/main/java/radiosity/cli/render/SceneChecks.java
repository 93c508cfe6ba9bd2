package radiosity.cli.render;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.stream.Stream;
import radiosity.cli.options.Failure;
import radiosity.cli.options.PictureSize;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.Snapshot;
import radiosity.output.lightmap.TextureBake;
import radiosity.scene.Hierarchy;
import radiosity.scene.Lamp;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Solution;
import radiosity.util.Aabb;
import radiosity.util.ArraySize;

/** Checks, before a render, for what would make it impossible, pointless or very long. */
public final class SceneChecks {

    /** Number of elements above which the user is warned about memory and time. */
    static final long MANY = 10_000_000;
    /** Lower bound of the memory per element, bytes. */
    private static final double LEAST_BYTES = 128;
    /** Entries per vertex of the longest array that pictures and tables of points need: 6 per element. */
    private static final int LARGEST_PER_VERTEX = 12;
    /** Number of surfaces or lamps that a warning names. */
    private static final int MOST_NAMES = 5;
    /** How far beyond the bounds a luminaire may be, in diagonals of the scene. */
    private static final double MARGIN = 0.1;

    private final Scene scene;
    private final Consumer<String> warnings;

    public SceneChecks(Scene scene, Consumer<String> warnings) {
        this.scene = scene;
        this.warnings = warnings;
    }

    public void light() {
        if (scene.lights().isEmpty() && scene.surfaces().stream().noneMatch(Surface::emits)) {
            warnings.accept(scene.name() + ": expected a light or a surface that emits, got none: all will be black");
        }
    }

    /** Warns of lamps whose light arrives nowhere. */
    public void unseen(List<Lamp> lamps) {
        if (!lamps.isEmpty()) {
            warnings.accept(scene.name() + ": expected lamps whose light arrives somewhere, got "
                    + (lamps.size() == 1 ? "one" : lamps.size()) + " enclosed, outside of the room, or on the wrong"
                    + " side of all that is visible: " + names(lamps.stream().map(this::text))
                    + (lamps.stream().anyMatch(this::isOutside) ? " (--leave-out leaves panes out)" : ""));
        }
    }

    private boolean isOutside(Lamp lamp) {
        return !lamp.surface() && scene.lights().get(lamp.index()).kind().isOutside();
    }

    private String text(Lamp lamp) {
        return lamp.surface() || isOutside(lamp) ? lamp.name()
                : lamp.name() + " at " + text(scene.lights().get(lamp.index()).position());
    }

    private static String names(Stream<String> names) {
        List<String> some = names.distinct().toList();
        return String.join(", ", some.subList(0, Math.min(MOST_NAMES, some.size())))
                + (some.size() > MOST_NAMES ? ", ..." : "");
    }

    /**
     * Warns of each luminaire that is outside of the scene's bounds and not aimed at them: mostly its unit of length or
     * the sign of an axis is wrong. A lamp above an open floor is aimed at the floor.
     */
    public void luminaires() {
        if (scene.lights().stream().allMatch(light -> light.luminaire().isEmpty())) {
            return;
        }
        Aabb box = Aabb.of(scene.points());
        for (Light light : scene.lights()) {
            Vec3 p = light.position();
            if (light.luminaire().isPresent() && !meets(p, light.direction(), box)) {
                warnings.accept(String.format(Locale.ROOT, "%s: expected luminaires in the scene or aimed at it, got %s"
                        + " at %s, outside of %s to %s; check unit and axes", scene.name(), light.name(), text(p),
                        text(box.low()), text(box.high())));
            }
        }
    }

    private static String text(Vec3 p) {
        return String.format(Locale.ROOT, "%.6g,%.6g,%.6g", p.x(), p.y(), p.z());
    }

    /** Whether a ray begins in a box that is {@link #MARGIN} of the diagonal larger at each side, or meets it. */
    private static boolean meets(Vec3 from, Vec3 direction, Aabb box) {
        double more = MARGIN * box.diagonal();
        double begin = 0;
        double end = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double low = box.low().coordinate(k) - more - from.coordinate(k);
            double high = box.high().coordinate(k) + more - from.coordinate(k);
            double d = direction.coordinate(k);
            if (d == 0 && (low > 0 || high < 0)) {
                return false;
            }
            if (d != 0) {
                begin = Math.max(begin, Math.min(low / d, high / d));
                end = Math.min(end, Math.max(low / d, high / d));
            }
        }
        return begin <= end;
    }

    /** Warns where the scene has more objects than a scene file can name. */
    public void objects() {
        Hierarchy objects = scene.hierarchy();
        if (objects.written() != objects) {
            warnings.accept(String.format(Locale.ROOT, "%s: expected at most %,d objects, whose names and hierarchy the"
                    + " scene file keeps, got %,d: it will have surfaces only", scene.name(), Hierarchy.MOST_WRITTEN,
                    objects.nodes().size()));
        }
    }

    /**
     * Warns of closed bodies that show their fronts to the inside only, where no light is.
     *
     * @param bodies the surfaces of each
     */
    public void insideOut(List<List<Surface>> bodies) {
        if (!bodies.isEmpty()) {
            warnings.accept(scene.name() + ": expected bodies that are seen from outside, got "
                    + (bodies.size() == 1 ? "one" : bodies.size()) + " inside out, which will be black: "
                    + names(bodies.stream().flatMap(List::stream).map(Surface::name))
                    + "; turn the polygons over, or make the surfaces two-sided");
        }
    }

    /** Fails where radiosity could exceed the floats of a scene file, by its bound exitance / (1 - reflectance). */
    public void emission() {
        double most = Solution.LARGEST * (1 - Surface.MAX_REFLECTANCE);
        for (Surface surface : scene.surfaces()) {
            if (surface.exitance().max() > most) {
                throw Failure.file(scene.name(), String.format(Locale.ROOT,
                        "expected surfaces that emit at most %.4g %s, got %.4g of %s", most, scene.units().exitance(),
                        surface.exitance().max(), surface.name()), null);
            }
        }
    }

    /**
     * Fails where the texture of a single triangle would be too large.
     *
     * @param option  that asks for the texture
     * @param samples texture samples per scene unit
     */
    public void textures(String option, double samples) {
        for (int t = 0; t < scene.triangles(); t++) {
            double longest = 0;
            for (int k = 0; k < 3; k++) {
                longest = Math.max(longest, scene.corner(t, k).minus(scene.corner(t, (k + 1) % 3)).length());
            }
            if (longest * samples / Math.sqrt(2) > TextureBake.LARGEST_TEXTURE) {
                throw Failure.commandLine(option, String.format(Locale.ROOT,
                        "expected at most %.4g samples per unit for %s, whose texture may have %d texels, got %s",
                        TextureBake.LARGEST_TEXTURE * Math.sqrt(2) / longest, scene.surface(t).name(),
                        TextureBake.LARGEST_TEXTURE, samples));
            }
        }
    }

    /** Fails where the light of each lamp is to be kept apart ({@code kept}) and there are too many lamps. */
    public void layers(boolean kept) {
        int lamps = scene.lamps().size();
        if (kept && lamps > RadiositySettings.MOST_LAMPS) {
            throw Failure.commandLine("--layers", "expected a scene of at most " + RadiositySettings.MOST_LAMPS
                    + " lamps, got " + lamps);
        }
    }

    /**
     * Warns of many elements, and fails where they cannot fit into memory.
     *
     * @param patchArea largest area of a patch, square scene units; 0 (chosen from the scene, within limits): no check
     * @param memory    available memory, bytes
     */
    public void elements(double patchArea, long memory) {
        double count = patches(patchArea);
        if (count * LEAST_BYTES > memory) {
            throw Failure.commandLine("-pa", String.format(Locale.ROOT,
                    "expected elements that fit %,d MiB of memory, got %,.0f or more, which need "
                            + "%,.0f MiB (JAVA_OPTS=-Xmx...)",
                    memory >> 20, count, count * LEAST_BYTES / (1 << 20)));
        }
        if (count > MANY) {
            warnings.accept(String.format(Locale.ROOT,
                    "-pa: expected a patch area that gives at most %,d elements, got %,.0f or more", MANY, count));
        }
    }

    /**
     * Fails where the light on the initial mesh exceeds an array, or its scene file exceeds the limit of glTF.
     *
     * @param patches  number of patches of the initial mesh; a plane mesh of n elements has more than n / 2 vertices
     * @param channels number of channels in which light is computed
     * @param layers   number of lamps whose light is kept apart; 0 for none
     */
    public static void sizes(double patches, int channels, int layers) {
        double vertices = patches / 2;
        double most = 2.0 * ArraySize.MOST / Math.max(LARGEST_PER_VERTEX, channels);
        if (patches > most) {
            throw Failure.commandLine("-pa", String.format(Locale.ROOT,
                    "expected at most %,.0f patches in %d channels, whose light fits an array, got "
                            + "%,.0f; give a larger -pa",
                    most, channels, patches));
        }
        double bytes = SceneFile.BYTES_PER_ELEMENT * patches
                + (SceneFile.BYTES_PER_VERTEX + (double) SceneFile.BYTES_PER_LAYER * layers) * vertices;
        if (bytes > SceneFile.MOST_BYTES) {
            throw Failure.commandLine("-pa", String.format(Locale.ROOT,
                    "expected patches whose scene file is at most %,d bytes, the limit of glTF, got "
                            + "%,.0f patches, which need"
                            + " %,.0f bytes or more; give a larger -pa", SceneFile.MOST_BYTES, patches, bytes));
        }
    }

    /**
     * Fails where the aspect ratio of the scene's camera makes pictures too high.
     *
     * @param width of pictures, pixels
     */
    public void pictures(int width) {
        long height = scene.camera().map(camera -> Snapshot.height(camera, width)).orElse(1L);
        if (height > PictureSize.MOST) {
            throw Failure.commandLine("--size", "expected pictures of at most " + PictureSize.MOST
                    + " pixels along an edge, got " + width + "x" + height + " by the camera of " + scene.name()
                    + "; give a size");
        }
    }

    /** Lower bound of the number of elements for a patch area; 0 where the area is 0 and so chosen from the scene. */
    public double patches(double patchArea) {
        return patchArea > 0 ? leastElements(patchArea) : 0;
    }

    /** A triangle of k times the patch area gives at least k elements on each radiating side. */
    private double leastElements(double patchArea) {
        double count = 0;
        for (int t = 0; t < scene.triangles(); t++) {
            count += Math.max(1, scene.area(t) / patchArea) * (scene.surface(t).twoSided() ? 2 : 1);
        }
        return count;
    }
}
