package radiosity.scene;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Brings the images of a scene to the resolution that a calculation of light needs. Elements take means over many
 * pixels, and the scene is sent to hosts and stored with the solution as one message. Pictures and models are made from
 * the images as they were read.
 */
public final class ImageBudget {

    /** Most pixels of one image. */
    private static final long MOST_OF_ONE = 1 << 20;
    /** Most pixels of all images together: 192 MiB of a message, whose bytes have to fit into one array. */
    private static final long MOST = 1 << 24;

    private ImageBudget() { }

    /**
     * The scene with its images halved until none has more than a million pixels, and all together at most 16 million:
     * the largest images are halved first. A scene whose images are that small is returned itself.
     */
    public static Scene reduce(Scene scene) {
        long most = MOST_OF_ONE;
        while (most > 1 && pixels(scene, most) > MOST) {
            most /= 4;
        }
        long limit = most;
        if (images(scene).allMatch(image -> image.pixels() <= limit)) {
            return scene;
        }
        List<Surface> surfaces = scene.surfaces().stream().map(surface -> surface.maps().isEmpty() ? surface
                : surface.with(new Surface.Maps(atMost(surface.maps().exitance(), limit),
                        atMost(surface.maps().reflectance(), limit)))).toList();
        return scene.with(surfaces, scene.lights());
    }

    private static Optional<Raster> atMost(Optional<Raster> image, long pixels) {
        return image.map(raster -> raster.atMost(pixels));
    }

    private static Stream<Raster> images(Scene scene) {
        return scene.surfaces().stream().map(Surface::maps)
                .flatMap(maps -> Stream.concat(maps.exitance().stream(), maps.reflectance().stream()));
    }

    /** Pixels of all images, each halved until it has at most {@code most}. */
    private static long pixels(Scene scene, long most) {
        return images(scene).mapToLong(image -> image.pixelsWithin(most)).sum();
    }
}
