package radiosity.input.lightwave.lwo;

import java.util.List;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;
import radiosity.input.polygon.Polygons;

/** Reads objects of LightWave 6 and later: LWO2, and LWO3 with its nested forms. One method per chunk. */
final class Lwo2Reader {

    private static final int CORNER_COUNT = 0x3FF;
    private static final List<String> FACES = List.of("FACE", "PTCH", "SUBD");

    private final ObjectModel object;
    private final Diagnostics notes;

    Lwo2Reader(ObjectModel object, Diagnostics notes) {
        this.object = object;
        this.notes = notes;
    }

    void read(ByteReader file) {
        Chunks chunks = new Chunks(file, 4, notes);
        while (chunks.next()) {
            chunk(chunks.id(), chunks.data(), chunks.place());
        }
    }

    private void chunk(String id, ByteReader data, String place) {
        switch (id) {
            case "TAGS" -> object.addTags(data, place, notes);
            case "LAYR" -> layer(data, place);
            case "PNTS" -> object.currentLayer().readPoints(data, place, notes);
            case "POLS" -> polygons(data, place);
            case "PTAG" -> polygonTags(data, place);
            case "VMAP" -> map(data, false, place);
            case "VMAD" -> map(data, true, place);
            case "CLIP" -> clip(data, place);
            case "SURF" -> object.addSurface(new Lwo2Surface(notes).read(data), place, notes);
            case "FORM" -> form(data, place);
            default -> { }
        }
    }

    /** Reads the surfaces and clips of LWO3, which are forms there and chunks in LWO2. */
    private void form(ByteReader data, String place) {
        switch (data.id()) {
            case "SURF" -> object.addSurface(new Lwo3Surface(notes).read(data, place), place, notes);
            case "CLIP" -> Lwo3Surface.readClip(data, object, place, notes);
            default -> { }
        }
    }

    private void layer(ByteReader data, String place) {
        int number = data.u2();
        data.skip(2);
        double[] pivot = LwobTexture.vector(data);
        if (data.ranOut() || !Double.isFinite(pivot[0] + pivot[1] + pivot[2])) {
            notes.note(place, "the pivot of a layer is missing or no number, the origin is taken");
            pivot = new double[3];
        }
        object.addLayer(new Layer(number, pivot), place, notes);
    }

    private void polygons(ByteReader data, String place) {
        Layer layer = object.currentLayer();
        layer.firstPolygon = layer.polygons.size();
        String type = data.id();
        boolean faces = FACES.contains(type);
        if (faces && !type.equals("FACE")) {
            notes.note(place, "subdivision surfaces are taken as the polygons of their cage");
        }
        while (data.has(2)) {
            if (!polygon(layer, data, faces)) {
                notes.note(place, "the last polygon is cut short and left out");
                return;
            }
        }
    }

    private static boolean polygon(Layer layer, ByteReader data, boolean taken) {
        for (int corners = data.u2() & CORNER_COUNT; corners > 0; corners--) {
            if (!data.hasVx()) {
                layer.polygons.closeEmpty();
                return false;
            }
            layer.polygons.corner(layer.firstPoint + data.vx());
        }
        if (taken) {
            layer.polygons.close(Polygons.UNTAGGED);
        } else {
            layer.polygons.closeEmpty();
        }
        return true;
    }

    private void polygonTags(ByteReader data, String place) {
        if (!data.id().equals("SURF")) {
            return;
        }
        Layer layer = object.currentLayer();
        while (data.hasVx() && data.has(4)) {
            int polygon = layer.firstPolygon + data.vx();
            int tag = data.u2();
            if (polygon < layer.polygons.size()) {
                layer.polygons.tag(polygon, tag);
            } else {
                notes.note(place, "a surface is given to a polygon that does not exist");
            }
        }
    }

    /** Reads texture coordinates of points (VMAP) or of polygon corners (VMAD). */
    private void map(ByteReader data, boolean ofCorners, String place) {
        if (!data.id().equals("TXUV")) {
            return;
        }
        Layer layer = object.currentLayer();
        int dimension = data.u2();
        VertexMap map = new VertexMap(data.s0());
        while (dimension >= 2 && data.hasVx() && data.has((ofCorners ? 4 : 2) + 4 * dimension)) {
            map.points.add(layer.firstPoint + data.vx());
            if (ofCorners) {
                map.polygons.add(layer.firstPolygon + data.vx());
            }
            map.values.add(data.f4());
            map.values.add(data.f4());
            data.skip(4 * (dimension - 2));
        }
        if (map.points.size() == 0) {
            notes.note(place, "texture coordinates without content are left out", map.name);
        } else {
            object.addMap(map, place, notes);
        }
    }

    private void clip(ByteReader data, String place) {
        int number = (int) data.u4();
        Chunks parts = new Chunks(data, 2, notes);
        while (parts.next()) {
            if (parts.id().equals("STIL")) {
                object.addClip(number, parts.data().s0(), place, notes);
            }
        }
    }
}
