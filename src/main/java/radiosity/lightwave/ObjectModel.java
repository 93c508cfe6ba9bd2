package radiosity.lightwave;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What an object file holds, as it lists it. */
final class ObjectModel {

    final String name;
    /** LWOB, LWLO, LWO2 or LWO3. */
    final String format;
    final List<Layer> layers = new ArrayList<>();
    /** Surface names by the numbers that polygons give. */
    final List<String> tags = new ArrayList<>();
    final Map<String, SurfaceValues> surfaces = new LinkedHashMap<>();
    /** Image paths by number. */
    final Map<Integer, String> clips = new HashMap<>();

    ObjectModel(String name, String format) {
        this.name = name;
        this.format = format;
    }

    /** The layer to which data belong that stand before any layer's head. */
    Layer currentLayer() {
        if (layers.isEmpty()) {
            layers.add(new Layer(0));
        }
        return layers.get(layers.size() - 1);
    }

    void addSurface(SurfaceValues surface, String place, Notes notes) {
        if (surfaces.put(surface.name, surface) != null) {
            notes.note(place, "a surface is described twice, the last time counts", surface.name);
        }
    }

    boolean isOld() {
        return format.equals("LWOB") || format.equals("LWLO");
    }
}
