package radiosity.input.lightwave.lwo;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;

/**
 * Reads the values of the material from the node graph of an LWO3 surface.
 *
 * <p>The material is the node at the input "Material" of the node "Surface"; where that node only mixes materials, the
 * first material found breadth-first among its sources is taken.
 */
final class NodeGraph {

    /** Names of inputs, and the channel that an image at such an input varies; others are left out silently. */
    private static final Map<String, String> CHANNELS = Map.of("Color", "COLR", "Diffuse", "DIFF", "Luminosity", "LUMI",
            "Luminous", "LUMI", "Luminous Color", "LUMC", "Transparency", "TRAN", "Reflection", "REFL");

    private final Diagnostics notes;
    /** By node: the name of the source node of each input, by the input's name. */
    private final Map<String, Map<String, String>> inputs = new HashMap<>();
    private final Map<String, MaterialNode> materials = new HashMap<>();
    /** By node: the source nodes of its inputs, in the file's order. */
    private final Map<String, Deque<String>> sources = new HashMap<>();
    private String materialOfSurface = "";

    NodeGraph(Diagnostics notes) {
        this.notes = notes;
    }

    /** @param data the content of the form NODS */
    void read(ByteReader data, SurfaceValues surface, String place) {
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals("FORM")) {
                switch (chunks.data().id()) {
                    case "NNDS" -> nodes(chunks.data());
                    case "NCON" -> connections(chunks.data());
                    default -> { }
                }
            }
        }
        Optional<MaterialNode> material = material();
        if (material.isPresent()) {
            material.get().apply(surface);
            Map<String, String> linked = inputs.getOrDefault(material.get().name(), Map.of());
            linked.forEach((i, s) -> input(surface, i, s));
            material.get().layers().forEach((input, layers) -> {
                if (!linked.containsKey(input)) {
                    layers.forEach(layer -> add(surface, CHANNELS.get(input), layer));
                }
            });
        } else {
            notes.note(place, "no material is found among the nodes of a surface", surface.name);
        }
    }

    private void nodes(ByteReader data) {
        String server = "";
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals("NSRV")) {
                server = chunks.data().s0();
            } else if (chunks.id().equals("FORM") && chunks.data().id().equals("NTAG")) {
                MaterialNode node = MaterialNode.read(server, chunks.data(), notes);
                materials.putIfAbsent(node.name(), node);
            }
        }
    }

    /** Reads the links, of four chunks each: node, its input, source node, its output. */
    private void connections(ByteReader data) {
        String node = "";
        String input = "";
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            switch (chunks.id()) {
                case "INME" -> node = chunks.data().s0();
                case "IINM" -> input = chunks.data().s0();
                case "IINN" -> connect(node, input, chunks.data().s0());
                default -> { }
            }
        }
    }

    private void connect(String node, String input, String source) {
        sources.computeIfAbsent(node, n -> new ArrayDeque<>()).add(source);
        if (node.equals("Surface") && input.equals("Material")) {
            materialOfSurface = source;
        }
        inputs.computeIfAbsent(node, n -> new LinkedHashMap<>()).put(input, source);
    }

    /** Adds the image that a source node gives to an input of the material; other sources are noted and ignored. */
    private void input(SurfaceValues surface, String input, String source) {
        String channel = CHANNELS.get(input);
        MaterialNode node = materials.get(source);
        if (channel != null && node != null && node.image().isPresent()) {
            add(surface, channel, node.image().get());
        } else if (channel != null) {
            notes.note("", "inputs of materials that nodes other than images give are taken as their base values",
                    surface.name + "." + input);
        }
    }

    private static void add(SurfaceValues surface, String channel, TextureBlock texture) {
        if (channel != null) {
            surface.addTexture(texture.on(channel));
        }
    }

    private Optional<MaterialNode> material() {
        Deque<String> ahead = new ArrayDeque<>(Set.of(materialOfSurface));
        Set<String> seen = new HashSet<>(ahead);
        while (!ahead.isEmpty()) {
            String name = ahead.removeFirst();
            MaterialNode node = materials.get(name);
            if (node != null && node.isMaterial()) {
                return Optional.of(node);
            }
            for (String source : sources.getOrDefault(name, new ArrayDeque<>())) {
                if (seen.add(source)) {
                    ahead.addLast(source);
                }
            }
        }
        return Optional.empty();
    }
}
