package radiosity.output.image;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import radiosity.scene.ImageBudget;
import radiosity.scene.ImageMap;
import radiosity.scene.ImageSource;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;

/** Reads the images of a scene's surfaces and makes maps of exitance and reflectance from them. */
public final class SurfaceMaps {

    private static final String INSTEAD = "; the base colour is taken, a light grey where it is white";

    private final boolean srgb;
    private final Consumer<String> warnings;
    /** The images that were read and are used again; empty for an image that cannot be read. */
    private final Map<ImageSource, Optional<ImageFile>> images = new HashMap<>();
    /** By image: how often it is still to be used. */
    private final Map<ImageSource, Integer> uses = new HashMap<>();

    SurfaceMaps(boolean srgb, Consumer<String> warnings) {
        this.srgb = srgb;
        this.warnings = warnings;
    }

    /**
     * Returns the scene with maps from its images. An image that cannot be read is reported, and the base colour is
     * taken; of reflectances that are white then, a light grey.
     *
     * @param srgb whether the values of images are sRGB and are made linear
     */
    public static Scene read(Scene scene, boolean srgb, Consumer<String> warnings) {
        return new SurfaceMaps(srgb, warnings).read(scene);
    }

    Scene read(Scene scene) {
        ImageBudget budget = new ImageBudget(ImageFile.MOST_PIXELS, ImageFile.MOST_PIXELS);
        List<Surface> surfaces = new ArrayList<>();
        scene.surfaces().forEach(s -> s.textures().forEach(map -> uses.merge(map.image(), 1, Integer::sum)));
        long pixels = 0;
        for (Surface surface : scene.surfaces()) {
            Surface read = read(surface);
            surfaces.add(read);
            pixels += pixels(read);
            if (pixels > ImageFile.MOST_PIXELS || pixels(read) > budget.limit()) {
                surfaces = new ArrayList<>(budget.reduce(surfaces));
                pixels = surfaces.stream().mapToLong(SurfaceMaps::pixels).sum();
            }
        }
        if (budget.limit() < ImageFile.MOST_PIXELS) {
            warnings.accept("images: expected at most " + ImageFile.MOST_PIXELS + " pixels in all, got more; those of"
                    + " more than " + budget.limit() + " are taken at half their size or less");
        }
        return scene.with(surfaces, scene.lights());
    }

    /** Number of images that are in memory. */
    int images() {
        return images.size();
    }

    private static long pixels(Surface surface) {
        return surface.maps().exitance().map(Raster::pixels).orElse(0L)
                + surface.maps().reflectance().map(Raster::pixels).orElse(0L);
    }

    private Surface read(Surface surface) {
        if (surface.textures().isEmpty()) {
            return surface;
        }
        Surface.Maps maps = new Surface.Maps(
                raster(surface, ImageMap.Target.EXITANCE, surface.exitance(), Double.MAX_VALUE),
                raster(surface, ImageMap.Target.REFLECTANCE, surface.reflectance(), Surface.MAX_REFLECTANCE));
        boolean isMissing = maps.reflectance().isEmpty()
                && surface.textures().stream().anyMatch(map -> map.target() == ImageMap.Target.REFLECTANCE);
        return (isMissing ? surface.withoutImage() : surface).with(maps);
    }

    private Optional<Raster> raster(Surface surface, ImageMap.Target target, Rgb base, double most) {
        List<ImageMap> maps = new ArrayList<>();
        List<ImageFile> files = new ArrayList<>();
        for (ImageMap map : surface.textures()) {
            Optional<ImageFile> image = map.target() == target ? image(map.image()) : Optional.empty();
            if (image.isPresent()) {
                maps.add(map);
                files.add(image.get());
            }
        }
        return maps.isEmpty() || isTooLarge(surface, files) ? Optional.empty()
                : Optional.of(raster(maps, files, base, most));
    }

    /**
     * Whether the images of one quantity, brought to one size, have too many pixels: more than any of them may have.
     */
    private boolean isTooLarge(Surface surface, List<ImageFile> files) {
        long pixels = (long) width(files) * height(files);
        if (pixels > ImageFile.MOST_PIXELS) {
            warnings.accept("surface " + surface.name() + ": expected images that together are at most "
                    + ImageFile.MOST_PIXELS + " pixels, got " + width(files) + "x" + height(files)
                    + INSTEAD);
        }
        return pixels > ImageFile.MOST_PIXELS;
    }

    private static int width(List<ImageFile> files) {
        return files.stream().mapToInt(ImageFile::width).max().orElseThrow();
    }

    private static int height(List<ImageFile> files) {
        return files.stream().mapToInt(ImageFile::height).max().orElseThrow();
    }

    private Optional<ImageFile> image(ImageSource source) {
        Optional<ImageFile> file = images.computeIfAbsent(source, image -> {
            try {
                ImageFile read = ImageFile.read(image);
                if (read.step() > 1) {
                    warnings.accept(image.name() + ": expected at most " + ImageFile.MOST_PIXELS + " pixels, got more;"
                            + " one of " + read.step() + " pixels along rows and columns is taken");
                }
                return Optional.of(read);
            } catch (IOException | InvalidPathException e) {
                warnings.accept(image.name() + ": expected an image, got " + e.getMessage()
                        + INSTEAD);
                return Optional.empty();
            }
        });
        if (uses.merge(source, -1, Integer::sum) == 0) {
            images.remove(source);
        }
        return file;
    }

    /** Combines the images of one quantity in a map as wide and as high as the largest of them. */
    private Raster raster(List<ImageMap> maps, List<ImageFile> files, Rgb base, double most) {
        int width = width(files);
        int height = height(files);
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            int x = i / 3 % width;
            int y = i / 3 / width;
            boolean isOfImages = base.channel(i % 3) == 0 && maps.size() > 1;
            double value = isOfImages ? 1 : base.channel(i % 3);
            for (int m = 0; m < maps.size(); m++) {
                ImageFile file = files.get(m);
                double image = file.value(x * file.width() / width, y * file.height() / height, i % 3, maps.get(m)
                        .grey(), srgb || maps.get(m).coded());
                value = isOfImages ? value * maps.get(m).opacity() * shown(maps.get(m), image)
                        : varied(maps.get(m), value, base.channel(i % 3), i % 3, image);
            }
            rgb[i] = (float) Math.max(0, Math.min(Math.min(most, Float.MAX_VALUE), value));
        }
        return new Raster(width, height, rgb, maps.get(0).wrapU(), maps.get(0).wrapV(), base);
    }

    /**
     * Applies an image to a value: several images for one quantity, as colour and diffuse, vary it by their product.
     * Where the quantity is 0 without them, as one of its factors is 0 that an image replaces, the value is the product
     * of the images alone.
     */
    private static double varied(ImageMap map, double before, double base, int channel, double image) {
        double alone = (1 - map.opacity()) * base + map.opacity() * map.scale().channel(channel) * shown(map, image);
        return base > 0 ? before * alone / base : alone;
    }

    private static double shown(ImageMap map, double image) {
        return map.negative() ? 1 - image : image;
    }
}
