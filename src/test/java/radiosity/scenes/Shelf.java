package radiosity.scenes;

import java.util.List;
import java.util.Random;
import radiosity.scenes.Solids.Face;

/** A bookcase, 1.3 m wide, 32 cm deep and 2.05 m high; its back is at z = 0 and it looks along -z. */
final class Shelf {

    private static final double HALF = 0.65;
    private static final double HEIGHT = 2.05;
    private static final double BOARD = 0.022;
    private static final double[] BOARDS = {0.08, 0.47, 0.86, 1.25, 1.64};
    private static final Material[] BINDINGS = {Palette.MIDNIGHT, Palette.BRICK, Palette.CREAM, Palette.TEAL,
        Palette.MUSTARD, Palette.WALNUT, Palette.RUST, Palette.PAPER, Palette.SKY_BLUE};

    private Shelf() {
    }

    /** Layer 1 the bookcase, 2 the books. */
    static byte[] object() {
        return ObjectFile.bytes(List.of(bookcase(), books()));
    }

    private static Layer bookcase() {
        Layer layer = new Layer("bookcase");
        Solids wood = new Solids(layer, Palette.BEECH);
        double inner = HALF - BOARD;
        wood.box(-HALF, 0, -0.012, HALF, HEIGHT, 0, Face.BELOW);
        wood.box(-HALF, 0, -0.32, -inner, HEIGHT, -0.012, Face.BELOW, Face.FAR);
        wood.box(inner, 0, -0.32, HALF, HEIGHT, -0.012, Face.BELOW, Face.FAR);
        wood.box(-inner, HEIGHT - BOARD, -0.32, inner, HEIGHT, -0.012, Face.LEFT, Face.RIGHT, Face.FAR);
        wood.box(-inner, 0, -0.29, inner, BOARDS[0], -0.275, Face.LEFT, Face.RIGHT, Face.BELOW, Face.ABOVE);
        for (double y : BOARDS) {
            wood.box(-inner, y, -0.315, inner, y + BOARD, -0.012, Face.LEFT, Face.RIGHT, Face.FAR);
        }
        return layer;
    }

    /** On each board a row of books from the left or from the right, sizes and colours by a fixed chance. */
    private static Layer books() {
        Layer layer = new Layer("books");
        Random chance = new Random(20);
        double[] filled = {1.16, 0.78, 0.95, 0.60, 0.86};
        for (int board = 0; board < BOARDS.length; board++) {
            row(layer, chance, BOARDS[board] + BOARD, filled[board], board % 2 == 0 ? 1 : -1);
        }
        return layer;
    }

    private static void row(Layer layer, Random chance, double y, double length, int direction) {
        double used = 0.01;
        while (used < length) {
            double thickness = 0.045 + 0.05 * chance.nextDouble();
            double height = 0.20 + 0.11 * chance.nextDouble();
            double front = -0.29 + 0.05 * chance.nextDouble();
            double near = -direction * (HALF - BOARD - used);
            double far = near + direction * thickness;
            Material binding = BINDINGS[chance.nextInt(BINDINGS.length)];
            new Solids(layer, binding).box(Math.min(near, far), y, front, Math.max(near, far), y + height, -0.04, Face.BELOW);
            used += thickness + 0.003;
        }
    }
}
