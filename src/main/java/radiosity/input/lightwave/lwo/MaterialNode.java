package radiosity.input.lightwave.lwo;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;
import radiosity.scene.Rgb;

/**
 * A node of an LWO3 surface with its values.
 *
 * @param server kind of the node
 * @param name   name of the node in its graph
 * @param values numbers of each attribute, by the attribute's name
 * @param image  the image of a node of the kind "Image"
 * @param layers the images laid on an attribute, by the attribute's name
 */
record MaterialNode(String server, String name, Map<String, double[]> values, Optional<TextureBlock> image,
                    Map<String, List<TextureBlock>> layers) {

    private static final int MOST_NUMBERS = 3;

    /** @param data the content of the form NTAG */
    static MaterialNode read(String server, ByteReader data, Diagnostics notes) {
        String name = "";
        Map<String, double[]> values = new HashMap<>();
        Map<String, List<TextureBlock>> layers = new LinkedHashMap<>();
        Optional<TextureBlock> image = Optional.empty();
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals("NNME")) {
                name = chunks.data().s0();
            } else if (chunks.id().equals("FORM") && chunks.data().id().equals("NDTA")) {
                image = server.equals("Image") ? ImageNode.read(chunks.data().copy(), notes) : image;
                ByteReader material = Chunks.form(chunks.data(), Set.of("ATTR", "SATR"), notes);
                ByteReader meta = Chunks.form(material, Set.of("META"), notes);
                attributes(Chunks.form(meta, Set.of("ADAT"), notes), values, layers, notes);
            }
        }
        return new MaterialNode(server, name, values, image, layers);
    }

    private static void attributes(ByteReader data, Map<String, double[]> values,
            Map<String, List<TextureBlock>> layers, Diagnostics notes) {
        Chunks entries = new Chunks(data, 4, notes);
        while (entries.next()) {
            if (entries.id().equals("FORM") && entries.data().id().equals("ENTR")) {
                attribute(entries.data(), values, layers, notes);
            }
        }
    }

    private static void attribute(ByteReader data, Map<String, double[]> values,
            Map<String, List<TextureBlock>> layers, Diagnostics notes) {
        String name = "";
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals("NAME")) {
                name = chunks.data().s0();
            } else if (chunks.id().equals("FORM") && chunks.data().id().equals("VALU")) {
                values.put(name, numbers(chunks.data().copy(), notes));
                layers.put(name, layers(chunks.data(), notes));
            }
        }
    }

    private static List<TextureBlock> layers(ByteReader data, Diagnostics notes) {
        List<TextureBlock> layers = new ArrayList<>(0);
        Chunks chunks = new Chunks(data, 4, notes.about(""));
        while (chunks.next()) {
            if (chunks.id().equals("FORM") && chunks.data().id().equals("TXTR")) {
                Lwo2Texture.readLayer(chunks.data(), notes).ifPresent(layers::add);
            }
        }
        return layers;
    }

    /** The numbers of a value: one number after its type's name in a chunk, or a count and numbers in an inner form. */
    private static double[] numbers(ByteReader data, Diagnostics notes) {
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals("    ")) {
                String type = chunks.data().s0();
                if (type.equals("double")) {
                    return new double[] {chunks.data().f8()};
                }
            } else if (chunks.id().equals("FORM") && chunks.data().id().equals("VALU")) {
                return counted(chunks.data(), notes);
            }
        }
        return new double[0];
    }

    private static double[] counted(ByteReader data, Diagnostics notes) {
        Chunks chunks = new Chunks(data, 4, notes);
        if (!chunks.next()) {
            return new double[0];
        }
        double[] numbers = new double[(int) Math.min(MOST_NUMBERS, chunks.data().u4())];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = chunks.data().f8();
        }
        return numbers;
    }

    /** Whether the node describes a reflecting material; surface nodes and mixing nodes have no colour. */
    boolean isMaterial() {
        return colour("Color") != null;
    }

    /** Sets the material's values in a surface; null for values that the node does not have. */
    void apply(SurfaceValues surface) {
        surface.colour = colour("Color");
        surface.diffuse = number("Diffuse");
        surface.luminosity = server.equals("Principled BSDF") ? number("Luminous") : number("Luminosity");
        surface.luminousColour = colour("Luminous Color");
        surface.specular = number("Specular");
        surface.transparency = number("Transparency");
        surface.reflection = number("Reflection");
        surface.glossiness = number("Glossiness");
        surface.refraction = number("Refraction Index");
    }

    private Double number(String attribute) {
        double[] numbers = values.get(attribute);
        return numbers == null || numbers.length == 0 ? null : Double.valueOf(numbers[0]);
    }

    private Rgb colour(String attribute) {
        double[] numbers = values.get(attribute);
        return numbers == null || numbers.length < 3 ? null : new Rgb(numbers[0], numbers[1], numbers[2]);
    }
}
