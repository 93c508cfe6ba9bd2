package radiosity.scenes;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Writes layers as a LightWave object (LWO2: an IFF file, big-endian, every chunk of even length). */
final class ObjectFile {

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();

    private ObjectFile() {
    }

    /** The bytes of an object with the layers 1, 2, … in the given order. */
    static byte[] bytes(List<Layer> layers) {
        Set<Material> materials = new LinkedHashSet<>();
        layers.forEach(layer -> materials.addAll(layer.materials()));
        List<Material> tags = List.copyOf(materials);
        ObjectFile form = new ObjectFile().id("LWO2").chunk("TAGS", names(tags));
        for (int n = 0; n < layers.size(); n++) {
            form.layer(n, layers.get(n), tags);
        }
        tags.forEach(material -> form.chunk("SURF", surface(material)));
        return new ObjectFile().chunk("FORM", form).out.toByteArray();
    }

    private static ObjectFile names(List<Material> tags) {
        ObjectFile data = new ObjectFile();
        tags.forEach(material -> data.text(material.name()));
        return data;
    }

    private void layer(int number, Layer layer, List<Material> tags) {
        ObjectFile head = new ObjectFile().u2(number).u2(0);
        for (double x : layer.pivot) {
            head.f4(x);
        }
        ObjectFile points = new ObjectFile();
        layer.points().forEach(point -> point.forEach(points::f4));
        ObjectFile polygons = new ObjectFile().id("FACE");
        ObjectFile surfaces = new ObjectFile().id("SURF");
        for (int k = 0; k < layer.polygons().size(); k++) {
            int[] corners = layer.polygons().get(k);
            polygons.u2(corners.length);
            for (int corner : corners) {
                polygons.u2(corner);
            }
            surfaces.u2(k).u2(tags.indexOf(layer.materials().get(k)));
        }
        chunk("LAYR", head.text(layer.name)).chunk("PNTS", points).chunk("POLS", polygons).chunk("PTAG", surfaces);
    }

    private static ObjectFile surface(Material material) {
        ObjectFile colour = new ObjectFile().f4(material.red()).f4(material.green()).f4(material.blue()).u2(0);
        ObjectFile surface = new ObjectFile().text(material.name()).text("")
                .subChunk("COLR", colour)
                .subChunk("DIFF", new ObjectFile().f4(material.diffuse()).u2(0))
                .subChunk("LUMI", new ObjectFile().f4(material.luminosity()).u2(0));
        if (material.mirrored() > 0) {
            surface.subChunk("REFL", new ObjectFile().f4(material.mirrored()).u2(0));
        }
        if (material.transparent() > 0) {
            surface.subChunk("TRAN", new ObjectFile().f4(material.transparent()).u2(0))
                    .subChunk("RIND", new ObjectFile().f4(material.index()).u2(0));
        }
        return surface.subChunk("SIDE", new ObjectFile().u2(material.sided()));
    }

    private ObjectFile chunk(String id, ObjectFile data) {
        return id(id).u2(data.out.size() >>> 16).u2(data.out.size()).append(data);
    }

    private ObjectFile subChunk(String id, ObjectFile data) {
        return id(id).u2(data.out.size()).append(data);
    }

    private ObjectFile append(ObjectFile data) {
        out.writeBytes(data.out.toByteArray());
        return this;
    }

    private ObjectFile id(String id) {
        out.writeBytes(id.getBytes(StandardCharsets.US_ASCII));
        return this;
    }

    /** Zero-terminated, of even length. */
    private ObjectFile text(String text) {
        return id(text).id(text.length() % 2 == 0 ? "\0\0" : "\0");
    }

    private ObjectFile u2(int value) {
        out.write(value >>> 8);
        out.write(value);
        return this;
    }

    private ObjectFile f4(double value) {
        int bits = Float.floatToIntBits((float) value);
        return u2(bits >>> 16).u2(bits);
    }
}
