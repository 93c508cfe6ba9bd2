package radiosity.mesh.face;

import java.util.List;
import radiosity.scene.Lamp;
import radiosity.scene.Scene;

/** Which channels there are for the light of a scene: colours, and of these as many as lamps are kept apart. */
final class Channels {

    /** 1 where everything in the scene is grey, else 3. */
    final int colours;
    /** What has a layer of its own; empty where all light is kept as one. */
    final List<Lamp> lamps;

    Channels(Scene scene, boolean layered) {
        lamps = layered ? scene.lamps() : List.of();
        colours = isGrey(scene) ? 1 : 3;
    }

    private static boolean isGrey(Scene scene) {
        return scene.surfaces().stream().allMatch(s -> s.exitance().isGrey() && s.reflectance().isGrey()
                && s.maps().isEmpty()) && scene.vertexColours().length == 0
                && scene.lights().stream().allMatch(l -> l.power().isGrey());
    }

    int layers() {
        return Math.max(1, lamps.size());
    }

    /** Whether the light of this surface, or of this light, is in a channel. */
    boolean isOf(boolean surface, int index, int channel) {
        if (lamps.isEmpty()) {
            return true;
        }
        Lamp lamp = lamps.get(channel / colours);
        return lamp.surface() == surface && lamp.index() == index;
    }
}
