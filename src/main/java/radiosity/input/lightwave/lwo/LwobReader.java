package radiosity.input.lightwave.lwo;

import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;

/** Reads objects of LightWave 5 and before: LWOB, and LWLO with its layers. One method per chunk. */
final class LwobReader {

    private final ObjectModel object;
    private final Diagnostics notes;

    LwobReader(ObjectModel object, Diagnostics notes) {
        this.object = object;
        this.notes = notes;
    }

    void read(ByteReader file) {
        Chunks chunks = new Chunks(file, 4, notes);
        while (chunks.next()) {
            switch (chunks.id()) {
                case "LAYR" -> object.addLayer(new Layer(chunks.data().u2()), chunks.place(), notes);
                case "PNTS" -> object.currentLayer().readPoints(chunks.data(), chunks.place(), notes);
                case "SRFS" -> object.addTags(chunks.data(), chunks.place(), notes);
                case "POLS" -> polygons(chunks.data(), chunks.place());
                case "PCHS" -> patches(chunks.data(), chunks.place());
                case "SURF" -> object.addSurface(new LwobSurface(notes).read(chunks.data()), chunks.place(), notes);
                default -> { }
            }
        }
    }

    private void patches(ByteReader data, String place) {
        notes.note(place, "patches are taken as the flat polygons of their corners");
        polygons(data, place);
    }

    private void polygons(ByteReader data, String place) {
        Layer layer = object.currentLayer();
        int details = 0;
        while (data.has(2)) {
            int corners = data.u2();
            if (!data.has(2 * corners + 2)) {
                notes.note(place, "the last polygon is cut short and left out");
                return;
            }
            int surface = polygon(layer, data, corners);
            if (details > 0) {
                details--;
            } else if (surface < 0) {
                details = data.u2();
            }
        }
    }

    /** Reads the corners and surface of a polygon; returns the surface's number, negative if detail polygons follow. */
    private static int polygon(Layer layer, ByteReader data, int corners) {
        for (int i = 0; i < corners; i++) {
            layer.polygons.corner(layer.firstPoint + data.u2());
        }
        int surface = data.i2();
        layer.polygons.close(Math.abs(surface) - 1);
        return surface;
    }
}
