package radiosity.input.lightwave.lwo;

import java.util.Optional;
import java.util.Set;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;

/**
 * Reads the texture layers at an input of a material in LWO3: blocks as in LWO2, but with sizes of 4 bytes, and forms
 * whose value stands in a chunk named by four spaces where an envelope may vary it.
 */
final class Lwo3Texture {

    private static final int NORMAL = 0;

    private final Diagnostics notes;
    private final TextureBlock texture = new TextureBlock();
    private boolean isImage;

    private Lwo3Texture(Diagnostics notes) {
        this.notes = notes;
    }

    /**
     * The image of a layer; empty for a procedural pattern or a gradient.
     *
     * @param layer the content of the form TXTR
     */
    static Optional<TextureBlock> read(ByteReader layer, Diagnostics notes) {
        Lwo3Texture reader = new Lwo3Texture(notes);
        Chunks chunks = new Chunks(Chunks.form(layer, Set.of("BLOK"), notes), 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals("FORM")) {
                reader.form(chunks.data().id(), chunks.data(), chunks.place());
            } else {
                reader.value(chunks.id(), chunks.data());
            }
        }
        return reader.isImage ? Optional.of(reader.texture) : Optional.empty();
    }

    private void form(String id, ByteReader data, String place) {
        switch (id) {
            case "IMAP" -> {
                isImage = true;
                head(data);
            }
            case "PROC", "GRAD" -> notes.note(place, "patterns and gradients on surfaces are left out");
            case "TMAP" -> placing(data);
            case "WRPW" -> texture.turns[0] = inner(data).f4();
            case "WRPH" -> texture.turns[1] = inner(data).f4();
            default -> { }
        }
    }

    private void head(ByteReader data) {
        Chunks parts = new Chunks(data, 4, notes);
        while (parts.next()) {
            if (parts.id().equals("ENAB")) {
                texture.enabled = parts.data().u2() != 0;
            } else if (parts.id().equals("NEGA")) {
                texture.negative = parts.data().u2() != 0;
            } else if (parts.id().equals("FORM") && parts.data().id().equals("OPAC")) {
                ByteReader opacity = inner(parts.data());
                if (opacity.u2() != NORMAL) {
                    notes.note(parts.place(), "a way of blending images other than normal is taken as normal");
                }
                texture.opacity = opacity.f4();
            }
        }
    }

    private void placing(ByteReader data) {
        Chunks parts = new Chunks(data, 4, notes);
        while (parts.next()) {
            if (parts.id().equals("CSYS")) {
                texture.world = parts.data().u2() == 1;
            } else if (parts.id().equals("FORM")) {
                switch (parts.data().id()) {
                    case "CNTR" -> texture.centre = LwobTexture.vector(inner(parts.data()));
                    case "SIZE" -> texture.size = LwobTexture.vector(inner(parts.data()));
                    case "ROTA" -> texture.rotation = LwobTexture.vector(inner(parts.data()));
                    default -> { }
                }
            }
        }
    }

    /** The value of a form; of no bytes where it is missing. */
    private ByteReader inner(ByteReader data) {
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            if (chunks.id().equals("    ")) {
                return chunks.data();
            }
        }
        return data;
    }

    private void value(String id, ByteReader data) {
        switch (id) {
            case "PROJ" -> texture.projection = Lwo2Texture.projection(data.u2());
            case "AXIS" -> texture.axis = Math.min(2, data.u2());
            case "IMAG" -> texture.clip = data.vx();
            case "WRAP" -> {
                texture.wrapU = Lwo2Texture.wrap(data.u2());
                texture.wrapV = Lwo2Texture.wrap(data.u2());
            }
            case "VMAP" -> texture.map = data.s0();
            default -> { }
        }
    }
}
