package radiosity.input.lightwave.lwo;

import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;
import radiosity.scene.Rgb;

/** Reads the SURF chunk of LWO2 objects. */
final class Lwo2Surface {

    private static final int BOTH_SIDES = 3;

    private final Diagnostics notes;
    private SurfaceValues surface;

    Lwo2Surface(Diagnostics notes) {
        this.notes = notes;
    }

    SurfaceValues read(ByteReader data) {
        surface = new SurfaceValues(data.s0(), data.s0());
        Chunks chunks = new Chunks(data, 2, notes);
        while (chunks.next()) {
            value(surface, chunks.id(), chunks.data(), chunks.place(), notes);
            if (chunks.id().equals("BLOK")) {
                Lwo2Texture.read(chunks.data(), notes).ifPresent(surface::addTexture);
            }
        }
        return surface;
    }

    /** Reads one value of a surface, from a chunk that LWO2 and LWO3 have in common. */
    static void value(SurfaceValues surface, String id, ByteReader data, String place, Diagnostics notes) {
        switch (id) {
            case "COLR" -> surface.colour = new Rgb(data.f4(), data.f4(), data.f4());
            case "DIFF" -> surface.diffuse = (double) data.f4();
            case "LUMI" -> surface.luminosity = (double) data.f4();
            case "SPEC" -> surface.specular = (double) data.f4();
            case "TRAN" -> surface.transparency = (double) data.f4();
            case "REFL" -> surface.reflection = (double) data.f4();
            case "GLOS" -> surface.glossiness = (double) data.f4();
            case "RIND" -> surface.refraction = (double) data.f4();
            case "SMAN" -> surface.smoothing = (double) data.f4();
            case "SIDE" -> surface.twoSided = data.u2() == BOTH_SIDES;
            default -> {
                return;
            }
        }
        if (data.ranOut()) {
            notes.note(place, "a value is cut short");
        }
        if (!id.equals("SIDE") && !id.equals("SMAN") && data.hasVx() && data.vx() != 0) {
            notes.note(place, "a surface value that changes in time is taken as its base value", surface.name);
        }
    }
}
