package radiosity.mesh.face;

import java.util.List;
import radiosity.scene.Lamp;
import radiosity.scene.Scene;

/** The channels of a scene's light: one per colour, repeated per lamp where the light of lamps is kept apart. */
final class Channels {

    /** 1 where everything in the scene is grey, else 3. */
    final int colours;
    /** The lamps that have a layer of channels each; empty where the light of all lamps is kept together. */
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

    /** Whether a channel holds the light that a surface emits ({@code surface} true), or that a light source emits. */
    boolean isOf(boolean surface, int index, int channel) {
        if (lamps.isEmpty()) {
            return true;
        }
        Lamp lamp = lamps.get(channel / colours);
        return lamp.surface() == surface && lamp.index() == index;
    }
}
