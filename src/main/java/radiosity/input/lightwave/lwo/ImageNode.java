package radiosity.input.lightwave.lwo;

import java.util.Optional;
import java.util.Set;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;
import radiosity.scene.ImageMap.Wrap;

/** Reads the node "Image" of an LWO3 surface: the image and its projection onto the points. */
final class ImageNode {

    private final Diagnostics notes;
    private final TextureBlock texture = new TextureBlock();

    private ImageNode(Diagnostics notes) {
        this.notes = notes;
    }

    /**
     * @param data the content of the form NDTA
     * @return empty if the node names no image
     */
    static Optional<TextureBlock> read(ByteReader data, Diagnostics notes) {
        ImageNode node = new ImageNode(notes);
        Chunks chunks = new Chunks(data, 4, notes);
        while (chunks.next()) {
            node.value(chunks.id(), chunks.data());
        }
        return Optional.of(node.texture).filter(t -> t.image != null);
    }

    private void value(String id, ByteReader data) {
        switch (id) {
            case "IMAP" -> texture.projection = projection(data.u4());
            case "IAXS" -> texture.axis = (int) Math.min(2, data.u4());
            case "IINV" -> texture.negative = data.u4() != 0;
            case "IUTL" -> texture.wrapU = wrap(data.u4());
            case "IVTL" -> texture.wrapV = wrap(data.u4());
            case "IUVI" -> texture.map = data.s0();
            case "FORM" -> form(data.id(), data);
            default -> { }
        }
    }

    private void form(String id, ByteReader data) {
        switch (id) {
            case "IIMG" -> clip(data);
            case "ISCL" -> texture.size = numbers(data, texture.size);
            case "IPOS" -> texture.centre = numbers(data, texture.centre);
            case "IROT" -> texture.rotation = numbers(data, texture.rotation);
            case "IUTD" -> texture.turns[0] = numbers(data, new double[] {1})[0];
            case "IVTD" -> texture.turns[1] = numbers(data, new double[] {1})[0];
            case "IOPC" -> texture.opacity = numbers(data, new double[] {1})[0];
            default -> { }
        }
    }

    private void clip(ByteReader data) {
        ByteReader still = Chunks.form(Chunks.form(data, Set.of("CLIP"), notes), Set.of("STIL"), notes);
        Chunks chunks = new Chunks(still, 4, notes);
        if (chunks.next()) {
            texture.image = chunks.data().s0();
        }
    }

    /** The numbers of a parameter, from form VPVL in form VPRM; a copy of {@code otherwise} where they are missing. */
    private double[] numbers(ByteReader data, double[] otherwise) {
        ByteReader value = Chunks.form(Chunks.form(data, Set.of("VPRM"), notes), Set.of("VPVL"), notes);
        Chunks chunks = new Chunks(value, 4, notes);
        double[] numbers = otherwise.clone();
        if (chunks.next() && chunks.data().has(4 * numbers.length)) {
            for (int i = 0; i < numbers.length; i++) {
                numbers[i] = chunks.data().f4();
            }
        }
        return numbers;
    }

    private static TextureBlock.Projection projection(long number) {
        return Lwo2Texture.projection((int) Math.min(9, number));
    }

    private static Wrap wrap(long number) {
        return Lwo2Texture.wrap((int) Math.min(9, number));
    }
}
