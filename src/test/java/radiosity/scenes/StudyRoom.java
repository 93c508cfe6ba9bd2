package radiosity.scenes;

import static radiosity.scenes.Vectors.point;

import java.util.List;
import java.util.stream.DoubleStream;
import radiosity.scenes.Solids.Face;
import radiosity.scenes.Solids.Open;

/**
 * The room of the {@link Study}: 6 m wide, 5.6 m deep and 2.7 m high, with a window in its left wall.
 *
 * <p>Walls and floor have holes where pictures and the rug cover them: what nobody sees takes no part.
 */
final class StudyRoom {

    private static final double LEFT = -3;
    static final double RIGHT = 3;
    static final double BACK = 5.6;
    private static final double HEIGHT = 2.7;
    /** How far skirting and cornice stand out, and between which heights the walls are bare. */
    private static final double SKIRTING = 0.014;
    private static final double CORNICE = 0.08;
    private static final double FOOT = 0.10;
    private static final double TOP = 2.61;
    private static final Area SIDE_WALL = new Area(0, FOOT, BACK, TOP);
    private static final Area END_WALL = new Area(LEFT, FOOT, RIGHT, TOP);
    /** The window: from its near to its far side, from sill to head, and the glass behind the wall's face. */
    private static final double NEAR = 2.75;
    private static final double FAR = 4.45;
    private static final double SILL = 0.85;
    private static final double HEAD = 2.3;
    private static final double GLASS = -3.25;
    /** Of the floor, x and z. */
    static final Area RUG = new Area(-1.4, 2.45, 1.0, 4.15);

    private StudyRoom() {
    }

    /** Layer 1 is what closes the room, 2 the fittings of the window. */
    static byte[] object() {
        return ObjectFile.bytes(List.of(shell(), window()));
    }

    private static Layer shell() {
        Layer shell = new Layer("shell");
        floor(shell);
        new Solids(shell, Palette.WOODWORK)
                .loft(Open.BOTH, inside(0, FOOT), inside(SKIRTING, FOOT - 0.01), inside(SKIRTING, 0))
                .loft(Open.BOTH, inside(CORNICE, HEIGHT), inside(0.065, 2.67), inside(0.02, 2.625), inside(0, TOP));
        shell.facing(Palette.CEILING, point(0, -1, 0), inside(CORNICE, HEIGHT));
        wall(shell, Palette.PLASTER, Vectors.AWAY, (x, y) -> point(x, y, 0), END_WALL, List.of());
        wall(shell, Palette.ACCENT, point(0, 0, -1), (x, y) -> point(x, y, BACK), END_WALL, Decor.onBackWall());
        wall(shell, Palette.PLASTER, point(-1, 0, 0), (z, y) -> point(RIGHT, y, z), SIDE_WALL, Decor.onRightWall());
        wall(shell, Palette.PLASTER, Vectors.RIGHT, (z, y) -> point(LEFT, y, z), SIDE_WALL,
                List.of(new Area(NEAR, SILL, FAR, HEAD)));
        pane(shell);
        return shell;
    }

    private static double[][] inside(double distance, double y) {
        return Rings.rectangle(LEFT + distance, distance, RIGHT - distance, BACK - distance, y);
    }

    /** Boards of 20 cm in four tones, their joints staggered. */
    private static void floor(Layer shell) {
        double width = 0.20;
        double length = 1.9;
        double back = BACK - SKIRTING;
        for (int row = 0; row < 30; row++) {
            double x0 = Math.max(LEFT + SKIRTING, LEFT + row * width);
            double x1 = Math.min(RIGHT - SKIRTING, LEFT + (row + 1) * width);
            double z = SKIRTING;
            for (int board = 0; z < back; board++) {
                double end = Math.min(back, length * (board + (1 + row * 2 % 5) / 5.0));
                board(shell, Palette.OAK[(row * 3 + board * 2 + row / 4) % 4], new Area(x0, z, x1, end));
                z = end;
            }
        }
    }

    /** What the rug leaves of a board. */
    private static void board(Layer shell, Material oak, Area board) {
        if (board.u1() <= RUG.u0() + 1e-9 || board.u0() >= RUG.u1() - 1e-9) {
            piece(shell, oak, board);
        } else {
            piece(shell, oak, new Area(board.u0(), board.v0(), board.u1(), Math.min(board.v1(), RUG.v0())));
            piece(shell, oak, new Area(board.u0(), Math.max(board.v0(), RUG.v1()), board.u1(), board.v1()));
        }
    }

    private static void piece(Layer shell, Material oak, Area piece) {
        if (piece.v1() > piece.v0()) {
            shell.facing(oak, Vectors.UP, point(piece.u0(), 0, piece.v0()), point(piece.u1(), 0, piece.v0()),
                    point(piece.u1(), 0, piece.v1()), point(piece.u0(), 0, piece.v1()));
        }
    }

    /** A point of a wall by its coordinates there. */
    private interface Plane {
        double[] at(double u, double v);
    }

    /** A wall with holes, as the rectangles into which their edges cut it. */
    private static void wall(Layer shell, Material material, double[] facing, Plane plane, Area wall,
            List<Area> holes) {
        double[] u = sorted(wall.u0(), wall.u1(), holes.stream()
                .flatMapToDouble(hole -> DoubleStream.of(hole.u0(), hole.u1())));
        double[] v = sorted(wall.v0(), wall.v1(), holes.stream()
                .flatMapToDouble(hole -> DoubleStream.of(hole.v0(), hole.v1())));
        for (int i = 1; i < u.length; i++) {
            for (int j = 1; j < v.length; j++) {
                double middle = (u[i - 1] + u[i]) / 2;
                double height = (v[j - 1] + v[j]) / 2;
                if (holes.stream().noneMatch(hole -> hole.contains(middle, height))) {
                    shell.facing(material, facing, plane.at(u[i - 1], v[j - 1]), plane.at(u[i], v[j - 1]),
                            plane.at(u[i], v[j]), plane.at(u[i - 1], v[j]));
                }
            }
        }
    }

    private static double[] sorted(double first, double last, DoubleStream between) {
        return DoubleStream.concat(DoubleStream.of(first, last), between).distinct().sorted().toArray();
    }

    /** The window's reveal and the sky behind it. */
    private static void pane(Layer shell) {
        new Solids(shell, Palette.WOODWORK).loft(Open.BOTH, frame(GLASS, 0), frame(LEFT, 0));
        double band = (HEAD - SILL) / Palette.SKY.length;
        for (int k = 0; k < Palette.SKY.length; k++) {
            double low = SILL + k * band;
            double high = k + 1 == Palette.SKY.length ? HEAD : low + band;
            shell.facing(Palette.SKY[k], Vectors.RIGHT, point(GLASS, low, NEAR), point(GLASS, low, FAR),
                    point(GLASS, high, FAR), point(GLASS, high, NEAR));
        }
    }

    /** Inside the window's reveal; a loft towards +x shows its front inside. */
    private static double[][] frame(double x, double inset) {
        return new double[][] {{x, SILL + inset, FAR - inset}, {x, SILL + inset, NEAR + inset},
            {x, HEAD - inset, NEAR + inset}, {x, HEAD - inset, FAR - inset}};
    }

    /** Frame, bars, sill and the pelmet from which the curtains hang. */
    private static Layer window() {
        Layer window = new Layer("window");
        double middle = (NEAR + FAR) / 2;
        double transom = SILL + 0.96;
        new Solids(window, Palette.WOODWORK)
                .loft(Open.BOTH, frame(-3.19, 0), frame(-3.19, 0.06), frame(-3.14, 0.06), frame(-3.14, 0))
                .box(-3.18, SILL + 0.06, middle - 0.03, -3.15, HEAD - 0.06, middle + 0.03, Face.BELOW, Face.ABOVE)
                .box(-3.18, transom, NEAR + 0.06, -3.15, transom + 0.035, middle - 0.03, Face.NEAR, Face.FAR)
                .box(-3.18, transom, middle + 0.03, -3.15, transom + 0.035, FAR - 0.06, Face.NEAR, Face.FAR)
                .box(LEFT, SILL - 0.04, NEAR - 0.03, LEFT + 0.12, SILL, FAR + 0.03, Face.LEFT);
        new Solids(window, Palette.WALNUT).box(LEFT, 2.42, 2.05, LEFT + 0.18, 2.48, 5.15, Face.LEFT);
        return window;
    }

    /** A curtain of five folds, 60 cm wide along +x from its pivot, 2.42 m high; it hangs from the pelmet above. */
    static byte[] curtain() {
        Layer curtain = new Layer("curtain");
        new Solids(curtain, Palette.LINEN).loft(Open.LAST, folds(0.02, 0.045), folds(2.42, 0.03));
        return ObjectFile.bytes(List.of(curtain));
    }

    private static double[][] folds(double y, double depth) {
        int n = 21;
        double[][] ring = new double[2 * n][];
        for (int k = 0; k < n; k++) {
            double x = 0.6 * k / (n - 1);
            double z = depth * StrictMath.sin(Math.PI / 2 * k);
            ring[k] = point(0.6 - x, y, z + 0.006);
            ring[2 * n - 1 - k] = point(0.6 - x, y, z - 0.006);
        }
        return ring;
    }
}
