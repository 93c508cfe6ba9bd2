package radiosity.scenes;

import static radiosity.scenes.Vectors.point;

import java.util.List;
import java.util.Random;
import radiosity.scenes.Solids.Face;

/** A bookcase, 1.3 m wide, 32 cm deep and 2.05 m high; its back is at z = 0 and it looks along -z. */
final class Shelf {

    private static final double HALF = 0.65;
    private static final double HEIGHT = 2.05;
    private static final double DEPTH = 0.32;
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

    /** One piece with a recess above each board. */
    private static Layer bookcase() {
        Layer layer = new Layer("bookcase");
        Solids wood = new Solids(layer, Palette.BEECH).box(-HALF, 0, -DEPTH, HALF, HEIGHT, 0, Face.BELOW, Face.NEAR);
        double inner = HALF - BOARD;
        front(layer, -HALF, 0, -inner, HEIGHT);
        front(layer, inner, 0, HALF, HEIGHT);
        front(layer, -inner, 0, inner, BOARDS[0] + BOARD);
        for (int board = 0; board < BOARDS.length; board++) {
            double next = board + 1 < BOARDS.length ? BOARDS[board + 1] : HEIGHT - BOARD;
            front(layer, -inner, next, inner, next + BOARD);
            wood.recess(-inner, BOARDS[board] + BOARD, -DEPTH, inner, next, -0.012);
        }
        return layer;
    }

    private static void front(Layer layer, double x0, double y0, double x1, double y1) {
        layer.facing(Palette.BEECH, point(0, 0, -1), point(x0, y0, -DEPTH), point(x1, y0, -DEPTH),
                point(x1, y1, -DEPTH), point(x0, y1, -DEPTH));
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
            new Solids(layer, binding)
                    .box(Math.min(near, far), y, front, Math.max(near, far), y + height, -0.04, Face.BELOW);
            used += thickness + 0.003;
        }
    }
}
