package radiosity.input.lightwave.lwo;

import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;

/** Reads the SURF and CLIP forms of LWO3: chunks with sizes of 4 bytes, the name in a chunk named by four spaces. */
final class Lwo3Surface {

    private static final String HEAD = "    ";

    private final Diagnostics notes;

    Lwo3Surface(Diagnostics notes) {
        this.notes = notes;
    }

    SurfaceValues read(ByteReader data, String place) {
        SurfaceValues surface = head(data.copy(), place);
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals("FORM")) {
                form(surface, chunks.data(), chunks.place());
            } else {
                Lwo2Surface.value(surface, chunks.id(), chunks.data(), chunks.place(), notes);
            }
        }
        return surface;
    }

    private SurfaceValues head(ByteReader data, String place) {
        Chunks chunks = new Chunks(data, 4, notes.about(""));
        while (chunks.next()) {
            if (chunks.id().equals(HEAD)) {
                return new SurfaceValues(chunks.data().s0(), chunks.data().s0());
            }
        }
        notes.note(place, "a surface has no name");
        return new SurfaceValues("", "");
    }

    private void form(SurfaceValues surface, ByteReader data, String place) {
        if (data.id().equals("NODS")) {
            new NodeGraph(notes).read(data, surface, place);
        }
    }

    /** Reads the number and the path of an image. */
    static void readClip(ByteReader data, ObjectModel object, String place, Diagnostics notes) {
        int number = 0;
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals(HEAD)) {
                number = (int) chunks.data().u4();
            } else if (chunks.id().equals("FORM") && chunks.data().id().equals("STIL")) {
                still(chunks.data(), number, object, place, notes);
            }
        }
    }

    private static void still(ByteReader data, int number, ObjectModel object, String place, Diagnostics notes) {
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals(HEAD)) {
                object.addClip(number, chunks.data().s0(), place, notes);
            }
        }
    }
}
