package radiosity.scene;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Halves the images of a scene, the largest first, until they have no more pixels than are needed. Belongs to one
 * thread.
 */
public final class ImageBudget {

    /** Most pixels of one image in a calculation of light: elements take means over many pixels. */
    private static final long LIGHT_OF_ONE = 1 << 20;
    /** Most pixels of all images in a calculation of light: 48 MiB of a message, and of a scene file. */
    private static final long LIGHT = 1 << 22;

    private final long most;
    private long limit;

    /**
     * @param ofOne most pixels of one image
     * @param most  most pixels of all images together
     */
    public ImageBudget(long ofOne, long most) {
        this.most = most;
        limit = ofOne;
    }

    /**
     * The scene with images as a calculation of light needs them: none has more than a million pixels, and all together
     * have at most 4 million. It is sent to hosts and stored with the solution. Pictures and models are made from the
     * images as they were read. A scene whose images are that small is returned itself.
     */
    public static Scene forLight(Scene scene) {
        ImageBudget budget = new ImageBudget(LIGHT_OF_ONE, LIGHT);
        List<Surface> surfaces = budget.reduce(scene.surfaces());
        return surfaces == scene.surfaces() ? scene : scene.with(surfaces, scene.lights());
    }

    /** Most pixels of one image; becomes smaller where {@link #reduce} is given too many images. */
    public long limit() {
        return limit;
    }

    /** The surfaces with reduced images; the list itself where no image has to be reduced. */
    public List<Surface> reduce(List<Surface> surfaces) {
        while (limit > 1 && pixels(surfaces, limit) > most) {
            limit /= 4;
        }
        if (images(surfaces).allMatch(image -> image.pixels() <= limit)) {
            return surfaces;
        }
        return surfaces.stream().map(surface -> surface.maps().isEmpty() ? surface
                : surface.with(new Surface.Maps(reduce(surface.maps().exitance()),
                        reduce(surface.maps().reflectance())))).toList();
    }

    private Optional<Raster> reduce(Optional<Raster> image) {
        return image.map(raster -> raster.atMost(limit));
    }

    private static Stream<Raster> images(List<Surface> surfaces) {
        return surfaces.stream().map(Surface::maps)
                .flatMap(maps -> Stream.concat(maps.exitance().stream(), maps.reflectance().stream()));
    }

    /** Pixels of all images, each halved until it has at most {@code ofOne}. */
    private static long pixels(List<Surface> surfaces, long ofOne) {
        return images(surfaces).mapToLong(image -> image.pixelsWithin(ofOne)).sum();
    }
}
