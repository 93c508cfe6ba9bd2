package radiosity.scenes;

import static radiosity.scenes.Vectors.point;

import java.util.List;
import radiosity.scenes.Solids.Open;

/** Pictures and a plant. */
final class Decor {

    /** A picture by its layer, and where its middle hangs: along the wall and how high, m. */
    record Hung(int layer, double along, double height) {

        private Area covered() {
            double[] half = layer == 2 ? HILLS : SQUARES;
            return Area.around(along, height, half[0], half[1]);
        }
    }

    /** Half the width and the height of the frames. */
    private static final double[] SQUARES = {0.26, 0.26};
    private static final double[] HILLS = {0.48, 0.30};

    static final List<Hung> BACK_WALL = List.of(new Hung(1, -1.25, 1.55), new Hung(2, -0.40, 1.55),
            new Hung(3, 0.45, 1.55));
    static final List<Hung> RIGHT_WALL = List.of(new Hung(1, 3.55, 1.55));

    private Decor() {
    }

    /** What pictures cover of the back wall, x and y. */
    static List<Area> onBackWall() {
        return BACK_WALL.stream().map(Hung::covered).toList();
    }

    /** What pictures cover of the right wall, z and y. */
    static List<Area> onRightWall() {
        return RIGHT_WALL.stream().map(Hung::covered).toList();
    }

    /**
     * Three framed pictures, layers 1 to 3, that hang on a wall at z = 0 about their pivots and look along -z:
     * squares in squares, hills, squares in other colours.
     */
    static byte[] pictures() {
        return ObjectFile.bytes(List.of(
                squares("squares", Palette.MIDNIGHT, Palette.SKY_BLUE, Palette.CREAM, Palette.MUSTARD), hills(),
                squares("more squares", Palette.BRICK, Palette.RUST, Palette.ROSE, Palette.CREAM)));
    }

    private static Layer squares(String name, Material... colours) {
        Layer picture = new Layer(name);
        double half = SQUARES[0];
        frame(picture, SQUARES);
        for (int k = 0; k < colours.length; k++) {
            double outer = half - 0.10 - 0.04 * k;
            double drop = -0.012 * k;
            double[][] ring = upright(outer, outer, -0.010, drop);
            double[][] next = upright(outer - 0.04, outer - 0.04, -0.010, drop - 0.012);
            if (k + 1 < colours.length) {
                new Solids(picture, colours[k]).loft(Open.BOTH, ring, next);
            } else {
                picture.facing(colours[k], point(0, 0, -1), ring);
            }
        }
        return picture;
    }

    private static Layer hills() {
        Layer picture = new Layer("hills");
        double w = HILLS[0] - 0.10;
        double h = HILLS[1] - 0.10;
        frame(picture, HILLS);
        Material[] colours = {Palette.MIDNIGHT, Palette.TEAL, Palette.SKY_BLUE, Palette.ROSE, Palette.CREAM};
        double[][] lines = {{-h, -h, -h, -h, -h, -h, -h}, {-.12, -.15, -.14, -.10, -.05, -.07, -.10},
            {-.02, -.06, -.10, -.08, -.01, .00, -.04}, {.00, .06, .05, .00, .03, .02, .05},
                    {.10, .10, .10, .10, .10, .10, .10},
            {h, h, h, h, h, h, h}};
        for (int row = 0; row < colours.length; row++) {
            for (int k = 1; k < 7; k++) {
                double x0 = w * ((k - 1) / 3.0 - 1);
                double x1 = w * (k / 3.0 - 1);
                double[][] field = {{x0, lines[row][k - 1], -0.010}, {x1, lines[row][k], -0.010},
                    {x1, lines[row + 1][k], -0.010}, {x0, lines[row + 1][k - 1], -0.010}};
                picture.facing(colours[row], point(0, 0, -1), field);
            }
        }
        return picture;
    }

    /** A frame, open towards the wall, and a mount of 7 cm in it. */
    private static void frame(Layer picture, double[] half) {
        double w = half[0];
        double h = half[1];
        double[][] mount = upright(w - 0.03, h - 0.03, -0.010, 0);
        new Solids(picture, Palette.WALNUT).loft(Open.BOTH, upright(w, h, 0, 0), upright(w, h, -0.028, 0),
                upright(w - 0.008, h - 0.008, -0.03, 0), upright(w - 0.03, h - 0.03, -0.025, 0), mount);
        new Solids(picture, Palette.PAPER).loft(Open.BOTH, mount, upright(w - 0.10, h - 0.10, -0.010, 0));
    }

    /** A rectangle across z in which a loft towards -z has its front outside. */
    private static double[][] upright(double halfWidth, double halfHeight, double z, double y) {
        return new double[][] {{halfWidth, y + halfHeight, z}, {-halfWidth, y + halfHeight, z},
            {-halfWidth, y - halfHeight, z}, {halfWidth, y - halfHeight, z}};
    }

    /** A bow-string hemp in a clay pot, 1.1 m high. */
    static byte[] plant() {
        Layer plant = new Layer("plant");
        new Solids(plant, Palette.CLAY).lathe(Open.BOTH, 0, 0, 12,
                0.12, 0, 0.16, 0.26, 0.18, 0.26, 0.18, 0.31, 0.155, 0.31, 0.15, 0.27);
        new Solids(plant, Palette.SOIL).loft(Open.FIRST, Rings.circle(0, 0.27, 0, 0.15, 12));
        for (int k = 0; k < 13; k++) {
            leaf(plant, 2.4 * k, 0.02 + 0.0085 * k, 0.80 - 0.03 * k, 0.06 + 0.012 * k);
        }
        return ObjectFile.bytes(List.of(plant));
    }

    /** A two-sided blade from the soil that leans outwards and ends in a point. */
    private static void leaf(Layer plant, double angle, double distance, double length, double lean) {
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        double[] width = {0.018, 0.032, 0.034, 0.024, 0};
        double[][] left = new double[width.length][];
        double[][] right = new double[width.length][];
        for (int k = 0; k < width.length; k++) {
            double t = k / (width.length - 1.0);
            double r = distance + lean * t * (1 + t);
            double y = 0.27 + length * t * (1 - 0.1 * t);
            double twist = 0.5 * t;
            double u = width[k] * StrictMath.cos(angle + twist);
            double v = width[k] * StrictMath.sin(angle + twist);
            left[k] = point(r * c - v, y, r * s + u);
            right[k] = point(r * c + v, y, r * s - u);
        }
        for (int k = 1; k < width.length; k++) {
            plant.polygon(Palette.LEAF, left[k - 1], left[k], right[k]);
            plant.polygon(Palette.LEAF, left[k - 1], right[k], right[k - 1]);
        }
    }
}
