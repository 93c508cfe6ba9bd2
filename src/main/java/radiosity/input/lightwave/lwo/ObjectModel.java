package radiosity.input.lightwave.lwo;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;

/** The content of an object file, as the file lists it. */
public final class ObjectModel {

    /** Most layers, names, surfaces and images: files number layers and surfaces with 2 bytes. */
    static final int MOST = 65_536;
    private static final int MOST_MAPS = 10_000;

    final String name;
    /** LWOB, LWLO, LWO2 or LWO3. */
    public final String format;
    /** At least one layer once the file has been read, an empty one if the file has none. */
    public final List<Layer> layers = new ArrayList<>();
    /** Surface names, by the numbers that polygons refer to. */
    public final List<String> tags = new ArrayList<>();
    public final Map<String, SurfaceValues> surfaces = new LinkedHashMap<>();
    /** Image paths by number. */
    public final Map<Integer, String> clips = new HashMap<>();

    ObjectModel(String name, String format) {
        this.name = name;
        this.format = format;
    }

    private int maps;
    private Map<Integer, List<Layer>> byNumber;

    /** The latest layer; data before any layer's head get a layer 0 of their own. */
    Layer currentLayer() {
        if (layers.isEmpty()) {
            layers.add(new Layer(0));
        }
        return layers.get(layers.size() - 1);
    }

    void addLayer(Layer layer, String place, Diagnostics notes) {
        if (layers.size() < MOST) {
            layers.add(layer);
        } else {
            notes.note(place, "layers beyond " + MOST + " are taken as one");
        }
    }

    /** The layers with a number, mostly one or none; to be called only when the file has been read. */
    public List<Layer> layers(int number) {
        if (byNumber == null) {
            byNumber = layers.stream().collect(Collectors.groupingBy(l -> l.number));
        }
        return byNumber.getOrDefault(number, List.of());
    }

    /** @param data the rest of a chunk, names one after another */
    void addTags(ByteReader data, String place, Diagnostics notes) {
        while (data.has(1)) {
            String tag = data.s0();
            if (tags.size() < MOST) {
                tags.add(tag);
            } else {
                notes.note(place, "names beyond " + MOST + " are left out");
            }
        }
    }

    void addClip(int number, String path, String place, Diagnostics notes) {
        if (clips.size() < MOST) {
            clips.put(number, path);
        } else {
            notes.note(place, "images beyond " + MOST + " are left out");
        }
    }

    void addMap(VertexMap map, String place, Diagnostics notes) {
        if (maps++ < MOST_MAPS) {
            currentLayer().maps.add(map);
        } else {
            notes.note(place, "texture coordinates beyond " + MOST_MAPS + " maps are left out");
        }
    }

    void addSurface(SurfaceValues surface, String place, Diagnostics notes) {
        if (surfaces.size() >= MOST) {
            notes.note(place, "surfaces beyond " + MOST + " are left out");
        } else if (surfaces.put(surface.name, surface) != null) {
            notes.note(place, "a surface is described twice, the last time counts", surface.name);
        }
    }

    boolean isOld() {
        return format.equals("LWOB") || format.equals("LWLO");
    }
}
