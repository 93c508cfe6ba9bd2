package radiosity.input.lightwave.lws;

import java.util.List;
import java.util.Optional;
import radiosity.input.file.Diagnostics;
import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Vec3;

/** Makes the camera of a scene: the current one if the scene has several. */
public final class SceneCamera {

    private static final double DEFAULT_ZOOM = 3.2;
    /** Pixels of the picture's width and height where the file names a resolution by a number only. */
    private static final double[] DEFAULT_SIZE = {640, 480};

    private final SceneDescription scene;
    private final Placement placement;
    private final Motion.Instant instant;
    private final Diagnostics notes;

    public SceneCamera(SceneDescription scene, Placement placement, Motion.Instant instant, Diagnostics notes) {
        this.scene = scene;
        this.placement = placement;
        this.instant = instant;
        this.notes = notes;
    }

    public Optional<Camera> camera() {
        List<SceneItem> cameras = scene.items(SceneItem.Kind.CAMERA);
        if (cameras.isEmpty()) {
            return Optional.empty();
        }
        int current = scene.currentCamera();
        return camera(cameras.get(current >= 0 && current < cameras.size() ? current : 0));
    }

    private Optional<Camera> camera(SceneItem item) {
        Affine world = placement.world(item);
        Optional<Camera> found = Camera.of(new Vec3(world.m()[3], world.m()[7], 0 - world.m()[11]),
                SceneLights.right(world.direction(0, 0, 1)), SceneLights.right(world.direction(0, 1, 0)),
                StrictMath.atan(1 / item.number("ZoomFactor", instant, DEFAULT_ZOOM)), aspect(item));
        if (found.isEmpty()) {
            notes.note(item.place(), "a camera without a sound position, zoom or picture size is left out");
        }
        return found;
    }

    private double aspect(SceneItem item) {
        double[] pixels = item.numbers(item.either("FrameSize", "CustomSize"), instant, DEFAULT_SIZE);
        return pixels[0] * pixelAspect(item) / pixels[1];
    }

    /** Width of a pixel / its height: PixelAspect in LWSC 3 and later; before, 1 or a custom ratio. */
    private double pixelAspect(SceneItem item) {
        if (item.has("PixelAspect")) {
            return item.number("PixelAspect", instant, 1);
        }
        boolean custom = item.number("PixelAspectRatio", instant, 0) == -1;
        return custom && item.has("CustomSize") ? item.number("CustomPixelRatio", instant, 1) : 1;
    }
}
