package radiosity.input.lightwave.lwo;

import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;
import radiosity.scene.ImageMap.Wrap;

/**
 * Reads the texture blocks of surfaces: the blocks (BLOK) of LWO2, and the layers (TXTR) at an input of a material in
 * LWO3, whose sizes have 4 bytes, and where forms stand for chunks: the value that an envelope may vary is in a chunk
 * of the form that is named by four spaces.
 */
final class Lwo2Texture {

    private static final int NORMAL = 0;
    private static final int OLD_SIZE = 2;

    private final int sizeBytes;
    private final Diagnostics notes;
    private final TextureBlock texture = new TextureBlock();
    private boolean isImage;

    /** A chunk, or a form of LWO3 whose content stands behind the form's type. */
    private record Part(String id, ByteReader data, boolean isForm, String place) { }

    private Lwo2Texture(int sizeBytes, Diagnostics notes) {
        this.sizeBytes = sizeBytes;
        this.notes = notes;
    }

    /** The image that a block describes; empty for a procedural pattern, a gradient or a shader. */
    static Optional<TextureBlock> read(ByteReader block, Diagnostics notes) {
        return new Lwo2Texture(OLD_SIZE, notes).read(block);
    }

    /**
     * The image of a layer of LWO3; empty for a procedural pattern or a gradient.
     *
     * @param layer the content of the form TXTR
     */
    static Optional<TextureBlock> readLayer(ByteReader layer, Diagnostics notes) {
        return new Lwo2Texture(4, notes).read(Chunks.form(layer, Set.of("BLOK"), notes));
    }

    private Optional<TextureBlock> read(ByteReader block) {
        each(block, this::part);
        return isImage ? Optional.of(texture) : Optional.empty();
    }

    private void each(ByteReader container, Consumer<Part> found) {
        Chunks chunks = new Chunks(container, sizeBytes, notes);
        while (chunks.next()) {
            boolean isForm = sizeBytes != OLD_SIZE && chunks.id().equals("FORM");
            String id = isForm ? chunks.data().id() : chunks.id();
            found.accept(new Part(id, chunks.data(), isForm, chunks.place()));
        }
    }

    private void part(Part part) {
        switch (part.id) {
            case "IMAP" -> {
                isImage = true;
                if (sizeBytes == OLD_SIZE) {
                    part.data.s0();
                }
                each(part.data, this::head);
            }
            case "PROC", "GRAD" -> notes.note(part.place, "patterns and gradients on surfaces are left out");
            case "TMAP" -> each(part.data, this::placing);
            case "PROJ" -> texture.projection = projection(part.data.u2());
            case "AXIS" -> texture.axis = Math.min(2, part.data.u2());
            case "IMAG" -> texture.clip = part.data.vx();
            case "WRAP" -> {
                texture.wrapU = wrap(part.data.u2());
                texture.wrapV = wrap(part.data.u2());
            }
            case "WRPW" -> texture.turns[0] = value(part).f4();
            case "WRPH" -> texture.turns[1] = value(part).f4();
            case "VMAP" -> texture.map = part.data.s0();
            default -> { }
        }
    }

    private void head(Part part) {
        switch (part.id) {
            case "CHAN" -> texture.channel = part.data.id();
            case "ENAB" -> texture.enabled = part.data.u2() != 0;
            case "NEGA" -> texture.negative = part.data.u2() != 0;
            case "OPAC" -> {
                ByteReader opacity = value(part);
                if (opacity.u2() != NORMAL) {
                    notes.note(part.place, "a way of blending images other than normal is taken as normal");
                }
                texture.opacity = opacity.f4();
            }
            default -> { }
        }
    }

    private void placing(Part part) {
        switch (part.id) {
            case "CNTR" -> texture.centre = LwobTexture.vector(value(part));
            case "SIZE" -> texture.size = LwobTexture.vector(value(part));
            case "ROTA" -> texture.rotation = LwobTexture.vector(value(part));
            case "CSYS" -> texture.world = part.data.u2() == 1;
            default -> { }
        }
    }

    /** The value of a part; of no bytes where a form lacks the value. */
    private ByteReader value(Part part) {
        if (part.isForm) {
            Chunks chunks = new Chunks(part.data, sizeBytes, notes);
            while (chunks.next()) {
                if (chunks.id().equals("    ")) {
                    return chunks.data();
                }
            }
        }
        return part.data;
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
