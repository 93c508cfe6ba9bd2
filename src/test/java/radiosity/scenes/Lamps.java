package radiosity.scenes;

import static radiosity.scenes.Vectors.point;

import java.util.List;
import radiosity.scenes.Solids.Open;

/** The lamps of the study. */
final class Lamps {

    /** Joints of the desk lamp; their balls have this radius. */
    private static final double BALL = 0.016;
    private static final double[] ANKLE = {0, 0.022 + BALL, 0};
    private static final double[] ELBOW = {0, 0.40, 0};
    private static final double[] WRIST = {0, 0.78, 0};

    private Lamps() {
    }

    /** An opal globe under a ceiling that is at y = 0. */
    static byte[] pendant() {
        Layer pendant = new Layer("pendant");
        new Solids(pendant, Palette.BRASS)
                .lathe(Open.LAST, 0, 0, 8, 0.012, -0.03, 0.05, -0.022, 0.05, 0)
                .lathe(Open.NEITHER, 0, 0, 8, 0.055, -0.57, 0.055, -0.54, 0.012, -0.52);
        new Solids(pendant, Palette.BLACK).bar(Open.BOTH, point(0, -0.52, 0), point(0, -0.03, 0), 0.005);
        new Solids(pendant, Palette.OPAL).sphere(0, -0.72, 0, 0.15, 12);
        return ObjectFile.bytes(List.of(pendant));
    }

    /** Layer 1 foot, pole and bulb, 2 the two-sided shade, which three spokes carry. */
    static byte[] floorLamp() {
        Layer stand = new Layer("stand");
        Solids metal = new Solids(stand, Palette.BRASS);
        metal.lathe(Open.FIRST, 0, 0, 12, 0.15, 0, 0.15, 0.012, 0.13, 0.022, 0.02, 0.03);
        metal.bar(Open.FIRST, point(0, 0.03, 0), point(0, 1.375, 0), 0.012);
        new Solids(stand, Palette.BULB).sphere(0, 1.42, 0, 0.045, 6);
        Layer shade = new Layer("shade");
        new Solids(shade, Palette.SHADE).lathe(Open.BOTH, 0, 0, 18, 0.23, 1.27, 0.16, 1.60);
        for (int k = 0; k < 3; k++) {
            double angle = 2 * Math.PI * k / 3;
            double c = StrictMath.cos(angle);
            double s = StrictMath.sin(angle);
            new Solids(shade, Palette.BRASS).bar(Open.NEITHER, point(0.014 * c, 1.34, 0.014 * s),
                    point(0.199 * c, 1.40, 0.199 * s), 0.003);
        }
        return ObjectFile.bytes(List.of(stand, shade));
    }

    /** Modelled upright; layers 1 foot, 2 lower arm, 3 upper arm, 4 head turn about their pivots, the joints. */
    static byte[] deskLamp() {
        Layer foot = new Layer("foot");
        new Solids(foot, Palette.BRASS).lathe(Open.FIRST, 0, 0, 12, 0.09, 0, 0.09, 0.012, 0.02, 0.022);
        Layer lower = arm("lower arm", ANKLE, ELBOW);
        Layer upper = arm("upper arm", ELBOW, WRIST);
        Layer head = new Layer("head", WRIST);
        head(head, WRIST[1]);
        return ObjectFile.bytes(List.of(foot, lower, upper, head));
    }

    /** A thin rod that ends in the balls of its joints. */
    private static Layer arm(String name, double[] from, double[] to) {
        Layer arm = new Layer(name, from);
        double[] start = Vectors.plus(from, BALL, Vectors.UP);
        double[] end = Vectors.plus(to, -BALL, Vectors.UP);
        new Solids(arm, Palette.BRASS).bar(Open.NEITHER, start, end, 0.007).sphere(from[0], from[1], from[2], BALL, 6);
        return arm;
    }

    /** A bell of 3 mm that opens upwards, away from its joint at height y, with the bulb in it. */
    private static void head(Layer head, double y) {
        new Solids(head, Palette.TEAL).lathe(Open.LAST, 0, 0, 10,
                0.02, y + BALL, 0.045, y + 0.03, 0.06, y + 0.07, 0.105, y + 0.15);
        new Solids(head, Palette.CHINA).lathe(Open.FIRST, 0, 0, 10,
                0.105, y + 0.15, 0.102, y + 0.15, 0.057, y + 0.071, 0.042, y + 0.033, 0, y + 0.030);
        new Solids(head, Palette.BRASS).sphere(0, y, 0, BALL, 6);
        new Solids(head, Palette.DESK_BULB).sphere(0, y + 0.075, 0, 0.032, 6);
    }
}
