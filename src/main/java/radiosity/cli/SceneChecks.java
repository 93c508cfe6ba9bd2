package radiosity.cli;

import java.util.function.Consumer;
import radiosity.scene.Scene;
import radiosity.scene.Surface;

/** What makes a render pointless or very long, told before it starts. */
final class SceneChecks {

    /** From so many elements on, memory and time are worth a word. */
    static final long MANY = 10_000_000;

    private final Scene scene;
    private final Consumer<String> warnings;

    SceneChecks(Scene scene, Consumer<String> warnings) {
        this.scene = scene;
        this.warnings = warnings;
    }

    void light() {
        if (scene.lights().isEmpty() && scene.surfaces().stream().noneMatch(Surface::emits)) {
            warnings.accept(scene.name() + ": expected a light or a surface that emits, got none: all will be black");
        }
    }

    /** Counts as many elements as there are at least: a triangle of k times the patch area gives k or more. */
    void elements(double patchArea) {
        if (patchArea <= 0) {
            return;
        }
        double count = 0;
        for (int t = 0; t < scene.triangles(); t++) {
            count += Math.max(1, scene.area(t) / patchArea) * (scene.surface(t).twoSided() ? 2 : 1);
        }
        if (count > MANY) {
            warnings.accept(String.format("-pa: expected a patch area that gives at most %,d elements, got %,d or more",
                    MANY, (long) count));
        }
    }
}
