package radiosity.input.lightwave.lws;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The content of a scene file, before any object is read. */
public final class SceneDescription {

    /** First version whose items carry written identities; no file of version 4 itself is known. */
    static final int WITH_IDENTITIES = 4;

    private static final double DEFAULT_FRAMES_PER_SECOND = 30;

    public final int version;
    public final List<SceneItem> items = new ArrayList<>();
    private final Map<String, Double> globals = new HashMap<>();

    SceneDescription(int version) {
        this.version = version;
    }

    void put(String keyword, double number) {
        if (!Double.isNaN(number)) {
            globals.put(keyword, number);
        }
    }

    public double firstFrame() {
        return globals.getOrDefault("FirstFrame", 0.0);
    }

    int currentCamera() {
        return globals.getOrDefault("CurrentCamera", 0.0).intValue();
    }

    public double framesPerSecond() {
        double rate = globals.getOrDefault("FramesPerSecond", DEFAULT_FRAMES_PER_SECOND);
        return rate > 0 ? rate : DEFAULT_FRAMES_PER_SECOND;
    }

    public List<SceneItem> items(SceneItem.Kind kind) {
        return items.stream().filter(i -> i.kind == kind).toList();
    }
}
