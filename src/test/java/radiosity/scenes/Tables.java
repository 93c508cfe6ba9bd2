package radiosity.scenes;

import static radiosity.scenes.Vectors.point;

import java.util.List;
import radiosity.scenes.Solids.Face;
import radiosity.scenes.Solids.Open;

/** Coffee table, desk, and what lies on them. All stand at y = 0 about their pivot. */
final class Tables {

    private Tables() {
    }

    /** Round, 90 cm wide, 40 cm high. */
    static byte[] coffeeTable() {
        Layer table = new Layer("coffee table");
        Solids wood = new Solids(table, Palette.WALNUT);
        wood.lathe(Open.NEITHER, 0, 0, 20, 0.41, 0.37, 0.45, 0.385, 0.45, 0.395, 0.445, 0.40);
        for (int k = 0; k < 4; k++) {
            double c = StrictMath.cos(Math.PI / 4 * (2 * k + 1));
            double s = StrictMath.sin(Math.PI / 4 * (2 * k + 1));
            wood.leg(point(0.38 * c, 0, 0.38 * s), point(0.27 * c, 0.37, 0.27 * s), 0.05);
        }
        return ObjectFile.bytes(List.of(table));
    }

    /** 1.4 m along x, 65 cm deep, 75 cm high, two drawers on the right. */
    static byte[] desk() {
        Layer desk = new Layer("desk");
        Solids wood = new Solids(desk, Palette.WALNUT);
        wood.box(-0.70, 0.72, -0.325, 0.70, 0.75, 0.325);
        for (int side = -1; side <= 1; side += 2) {
            wood.leg(point(side * 0.66, 0, -0.29), point(side * 0.64, 0.72, -0.27), 0.05);
            wood.leg(point(side * 0.66, 0, 0.29), point(side * 0.64, 0.72, 0.27), 0.05);
        }
        wood.box(0.14, 0.56, -0.27, 0.58, 0.72, 0.27, Face.ABOVE);
        wood.box(0.15, 0.565, -0.285, 0.357, 0.71, -0.27, Face.FAR)
                .box(0.363, 0.565, -0.285, 0.57, 0.71, -0.27, Face.FAR);
        return ObjectFile.bytes(List.of(desk));
    }

    /** Layer 1 a bowl of oranges, 2 a vase, 3 a mug, 4 three books on each other, 5 an open book. */
    static byte[] tableware() {
        return ObjectFile.bytes(List.of(bowl(), vase(), mug(), pile(), openBook()));
    }

    private static Layer bowl() {
        Layer bowl = new Layer("bowl");
        new Solids(bowl, Palette.CHINA).lathe(Open.FIRST, 0, 0, 12,
                0.05, 0, 0.10, 0.02, 0.15, 0.075, 0.145, 0.075, 0.095, 0.028, 0, 0.015);
        new Solids(bowl, Palette.ORANGE).sphere(-0.035, 0.064, -0.03, 0.038, 8).sphere(0.045, 0.064, -0.012, 0.038, 8)
                .sphere(-0.005, 0.064, 0.05, 0.038, 8);
        return bowl;
    }

    private static Layer vase() {
        Layer vase = new Layer("vase");
        new Solids(vase, Palette.TEAL).lathe(Open.FIRST, 0, 0, 8,
                0.045, 0, 0.075, 0.05, 0.08, 0.10, 0.05, 0.18, 0.028, 0.23, 0.04, 0.27,
                0.034, 0.27, 0.022, 0.23, 0.02, 0.15, 0, 0.15);
        return vase;
    }

    private static Layer mug() {
        Layer mug = new Layer("mug");
        new Solids(mug, Palette.CHINA)
                .lathe(Open.FIRST, 0, 0, 10, 0.04, 0, 0.042, 0.09, 0.038, 0.09, 0.036, 0.01, 0, 0.01);
        return mug;
    }

    private static Layer pile() {
        Layer pile = new Layer("books");
        new Solids(pile, Palette.MIDNIGHT).box(-0.12, 0, -0.16, 0.12, 0.035, 0.16, Face.BELOW);
        new Solids(pile, Palette.MUSTARD).box(-0.10, 0.035, -0.14, 0.115, 0.06, 0.145, Face.BELOW);
        new Solids(pile, Palette.CREAM).box(-0.095, 0.06, -0.13, 0.085, 0.075, 0.12, Face.BELOW);
        return pile;
    }

    private static Layer openBook() {
        Layer book = new Layer("open book");
        for (int side = -1; side <= 1; side += 2) {
            double[][] half = new double[5][];
            double[] height = {0.004, 0.024, 0.028, 0.020, 0.006};
            for (int k = 0; k < half.length; k++) {
                half[k] = point(side * 0.04 * k, height[k], 0);
            }
            page(book, half, side);
        }
        return book;
    }

    /** One half of an open book: a curved block of pages, open towards what it lies on. */
    private static void page(Layer book, double[][] top, int side) {
        for (int k = 1; k < top.length; k++) {
            book.facing(Palette.PAPER, Vectors.UP, at(top[k - 1], -0.11), at(top[k], -0.11), at(top[k], 0.11),
                    at(top[k - 1], 0.11));
            for (int end = -1; end <= 1; end += 2) {
                double[] a = at(top[k - 1], 0.11 * end);
                double[] b = at(top[k], 0.11 * end);
                book.facing(Palette.PAPER, point(0, 0, end), a, b, point(b[0], 0, b[2]), point(a[0], 0, a[2]));
            }
        }
        double[] edge = top[top.length - 1];
        book.facing(Palette.PAPER, point(side, 0, 0), at(edge, -0.11), at(edge, 0.11), point(edge[0], 0, 0.11),
                point(edge[0], 0, -0.11));
    }

    private static double[] at(double[] p, double z) {
        return point(p[0], p[1], z);
    }

    /** Over all of its place in the room, with a border, 12 mm thick. */
    static byte[] rug() {
        Layer rug = new Layer("rug");
        double[][] inner = rectangle(0.20, 0.012);
        double[][] outer = rectangle(0.12, 0.012);
        new Solids(rug, Palette.CREAM).loft(Open.BOTH, rectangle(0, 0), rectangle(0, 0.012), outer)
                .loft(Open.FIRST, inner);
        new Solids(rug, Palette.BRICK).loft(Open.BOTH, outer, inner);
        return ObjectFile.bytes(List.of(rug));
    }

    private static double[][] rectangle(double inset, double y) {
        double halfWidth = (StudyRoom.RUG.u1() - StudyRoom.RUG.u0()) / 2 - inset;
        double halfDepth = (StudyRoom.RUG.v1() - StudyRoom.RUG.v0()) / 2 - inset;
        return Rings.rectangle(-halfWidth, -halfDepth, halfWidth, halfDepth, y);
    }
}
