package radiosity.scenes;

import static radiosity.scenes.Vectors.point;

import java.util.List;
import radiosity.scenes.Solids.Face;
import radiosity.scenes.Solids.Open;

/** The room of the {@link Study}: 6 m wide, 5.6 m deep and 2.7 m high, with a window in its left wall. */
final class StudyRoom {

    private static final double LEFT = -3;
    private static final double RIGHT = 3;
    private static final double BACK = 5.6;
    private static final double HEIGHT = 2.7;
    /** How far skirting and cornice stand out, and between which heights the walls are bare. */
    private static final double SKIRTING = 0.014;
    private static final double CORNICE = 0.08;
    private static final double FOOT = 0.10;
    private static final double TOP = 2.61;
    /** The window: from its near to its far side, from sill to head, and the glass behind the wall's face. */
    private static final double NEAR = 2.75;
    private static final double FAR = 4.45;
    private static final double SILL = 0.85;
    private static final double HEAD = 2.3;
    private static final double GLASS = -3.25;

    private StudyRoom() {
    }

    static byte[] object() {
        return ObjectFile.bytes(List.of(shell(), window()));
    }

    /** Closed: floor, skirting, walls, cornice and ceiling meet in edges and cover nothing of each other. */
    private static Layer shell() {
        Layer shell = new Layer("shell");
        floor(shell);
        double[][] low = inside(0, FOOT);
        double[][] high = inside(0, TOP);
        new Solids(shell, Palette.WOODWORK)
                .loft(Open.BOTH, low, inside(SKIRTING, FOOT - 0.01), inside(SKIRTING, 0))
                .loft(Open.BOTH, inside(CORNICE, HEIGHT), inside(0.065, 2.67), inside(0.02, 2.625), high);
        shell.facing(Palette.CEILING, point(0, -1, 0), inside(CORNICE, HEIGHT));
        for (int k = 0; k < 4; k++) {
            int next = (k + 1) % 4;
            if (k == 1) {
                windowWall(shell, low[k], low[next], high[next], high[k]);
            } else {
                shell.polygon(k == 0 ? Palette.ACCENT : Palette.PLASTER, low[next], high[next], high[k], low[k]);
            }
        }
        sky(shell);
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
                Material oak = Palette.OAK[(row * 3 + board * 2 + row / 4) % 4];
                shell.facing(oak, Vectors.UP, point(x0, 0, z), point(x1, 0, z), point(x1, 0, end), point(x0, 0, end));
                z = end;
            }
        }
    }

    /** A wall as four trapezoids around the window, and the window's reveal. Both run round as the wall is seen. */
    private static void windowWall(Layer shell, double[]... wall) {
        double[][] hole = {{LEFT, SILL, FAR}, {LEFT, SILL, NEAR}, {LEFT, HEAD, NEAR}, {LEFT, HEAD, FAR}};
        for (int k = 0; k < 4; k++) {
            int next = (k + 1) % 4;
            shell.polygon(Palette.PLASTER, wall[next], hole[next], hole[k], wall[k]);
            shell.polygon(Palette.WOODWORK, hole[next], behind(hole[next]), behind(hole[k]), hole[k]);
        }
    }

    private static double[] behind(double[] p) {
        return point(GLASS, p[1], p[2]);
    }

    private static void sky(Layer shell) {
        double band = (HEAD - SILL) / Palette.SKY.length;
        for (int k = 0; k < Palette.SKY.length; k++) {
            double low = SILL + k * band;
            double high = k + 1 == Palette.SKY.length ? HEAD : low + band;
            shell.facing(Palette.SKY[k], Vectors.RIGHT, point(GLASS, low, NEAR), point(GLASS, low, FAR),
                    point(GLASS, high, FAR), point(GLASS, high, NEAR));
        }
    }

    /** Frame, bars, sill and the pelmet from which the curtains hang. */
    private static Layer window() {
        Layer window = new Layer("window");
        double middle = (NEAR + FAR) / 2;
        Solids frame = new Solids(window, Palette.WOODWORK)
                .loft(Open.BOTH, frame(-3.19, 0), frame(-3.19, 0.06), frame(-3.14, 0.06), frame(-3.14, 0))
                .box(-3.18, SILL + 0.06, middle - 0.03, -3.15, HEAD - 0.06, middle + 0.03, Face.BELOW, Face.ABOVE)
                .box(LEFT, SILL - 0.04, NEAR - 0.03, LEFT + 0.12, SILL, FAR + 0.03, Face.LEFT);
        double transom = SILL + 0.96;
        frame.box(-3.18, transom, NEAR + 0.06, -3.15, transom + 0.035, middle - 0.03, Face.NEAR, Face.FAR)
                .box(-3.18, transom, middle + 0.03, -3.15, transom + 0.035, FAR - 0.06, Face.NEAR, Face.FAR);
        new Solids(window, Palette.WALNUT).box(LEFT, 2.42, 2.05, LEFT + 0.18, 2.48, 5.15, Face.LEFT);
        return window;
    }

    /** Inside the window's reveal. */
    private static double[][] frame(double x, double inset) {
        return new double[][] {{x, SILL + inset, FAR - inset}, {x, SILL + inset, NEAR + inset},
            {x, HEAD - inset, NEAR + inset}, {x, HEAD - inset, FAR - inset}};
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
