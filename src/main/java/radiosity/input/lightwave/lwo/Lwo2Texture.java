package radiosity.input.lightwave.lwo;

import java.util.Optional;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;
import radiosity.scene.ImageMap.Wrap;

/** Reads the texture blocks (BLOK) in the surfaces of LWO2 objects. */
final class Lwo2Texture {

    private static final int NORMAL = 0;

    private final Diagnostics notes;
    private final TextureBlock texture = new TextureBlock();

    private Lwo2Texture(Diagnostics notes) {
        this.notes = notes;
    }

    /** The image that a block describes; empty for a procedural pattern, a gradient or a shader. */
    static Optional<TextureBlock> read(ByteReader block, Diagnostics notes) {
        Lwo2Texture reader = new Lwo2Texture(notes);
        boolean image = false;
        Chunks chunks = new Chunks(block, 2, notes);
        while (chunks.next()) {
            switch (chunks.id()) {
                case "IMAP" -> {
                    image = true;
                    reader.head(chunks.data());
                }
                case "PROC", "GRAD" -> notes.note(chunks.place(), "patterns and gradients on surfaces are left out");
                case "TMAP" -> reader.placing(chunks.data());
                default -> reader.value(chunks.id(), chunks.data());
            }
        }
        return image ? Optional.of(reader.texture) : Optional.empty();
    }

    private void head(ByteReader data) {
        data.s0();
        Chunks parts = new Chunks(data, 2, notes);
        while (parts.next()) {
            switch (parts.id()) {
                case "CHAN" -> texture.channel = parts.data().id();
                case "ENAB" -> texture.enabled = parts.data().u2() != 0;
                case "NEGA" -> texture.negative = parts.data().u2() != 0;
                case "OPAC" -> opacity(parts.data(), parts.place());
                default -> { }
            }
        }
    }

    private void opacity(ByteReader data, String place) {
        int kind = data.u2();
        texture.opacity = data.f4();
        if (kind != NORMAL) {
            notes.note(place, "a way of blending images other than normal is taken as normal");
        }
    }

    private void placing(ByteReader data) {
        Chunks parts = new Chunks(data, 2, notes);
        while (parts.next()) {
            switch (parts.id()) {
                case "CNTR" -> texture.centre = LwobTexture.vector(parts.data());
                case "SIZE" -> texture.size = LwobTexture.vector(parts.data());
                case "CSYS" -> texture.world = parts.data().u2() == 1;
                case "ROTA" -> texture.rotation = LwobTexture.vector(parts.data());
                default -> { }
            }
        }
    }

    private void value(String id, ByteReader data) {
        switch (id) {
            case "PROJ" -> texture.projection = projection(data.u2());
            case "AXIS" -> texture.axis = Math.min(2, data.u2());
            case "IMAG" -> texture.clip = data.vx();
            case "WRAP" -> {
                texture.wrapU = wrap(data.u2());
                texture.wrapV = wrap(data.u2());
            }
            case "WRPW" -> texture.turns[0] = data.f4();
            case "WRPH" -> texture.turns[1] = data.f4();
            case "VMAP" -> texture.map = data.s0();
            default -> { }
        }
    }

    /** The projection of a number; numbers beyond the last one count as planar. */
    static TextureBlock.Projection projection(int number) {
        TextureBlock.Projection[] all = TextureBlock.Projection.values();
        return number < all.length ? all[number] : TextureBlock.Projection.PLANAR;
    }

    /** Wrap numbers of LWO2: 0 none, 1 repeat, 2 mirror, 3 edge; other numbers count as repeat. */
    static Wrap wrap(int number) {
        return switch (number) {
            case 0 -> Wrap.NONE;
            case 2 -> Wrap.MIRROR;
            case 3 -> Wrap.EDGE;
            default -> Wrap.REPEAT;
        };
    }
}
