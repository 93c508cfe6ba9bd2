package radiosity.scenes;

import static radiosity.scenes.Vectors.point;

import java.util.List;
import radiosity.scenes.Solids.Open;

/** Sofa, armchair, pillow and desk chair. All stand at y = 0 about their pivot and look along -z. */
final class Seats {

    private Seats() {
    }

    /** A sofa or an armchair with its seat cushions: layer 1; layer 2 is one cushion for the back. */
    static byte[] upholstered(double width, int seats, Material cloth) {
        double place = (width - 0.40) / seats;
        Layer body = new Layer("body");
        Solids soft = new Solids(body, cloth);
        double x = width / 2;
        soft.loft(Open.NEITHER, Rings.rounded(-x, -0.46, x, 0.45, 0.12, 0.03),
                Rings.rounded(-x, -0.46, x, 0.45, 0.30, 0.03));
        soft.cushion(-x + 0.025, 0.30, -0.43, -x + 0.195, 0.60, 0.42, false, 0.045, 0.01);
        soft.cushion(x - 0.195, 0.30, -0.43, x - 0.025, 0.60, 0.42, false, 0.045, 0.01);
        soft.cushion(-x + 0.205, 0.30, 0.26, x - 0.205, 0.80, 0.42, false, 0.045, 0.005);
        for (int k = 0; k < seats; k++) {
            double left = -x + 0.20 + k * place + 0.006;
            soft.cushion(left, 0.30, -0.435, left + place - 0.012, 0.44, 0.25, false, 0.045, 0.025);
        }
        Solids wood = new Solids(body, Palette.WALNUT);
        for (int side = -1; side <= 1; side += 2) {
            wood.leg(point(side * (x - 0.08), 0, -0.38), point(side * (x - 0.10), 0.12, -0.36), 0.05);
            wood.leg(point(side * (x - 0.08), 0, 0.37), point(side * (x - 0.10), 0.12, 0.35), 0.05);
        }
        Layer back = new Layer("back cushion");
        double half = place / 2 - 0.008;
        new Solids(back, cloth).cushion(-half, 0, -0.075, half, 0.44, 0.075, true, 0.05, 0.012);
        return ObjectFile.bytes(List.of(body, back));
    }

    /** A square pillow, 44 cm wide, upright on one edge. */
    static byte[] pillow(Material cloth) {
        Layer pillow = new Layer("pillow");
        double[][][] rings = {slice(-0.08, 0.11), slice(-0.05, 0.18), slice(0, 0.22),
            slice(0.05, 0.18), slice(0.08, 0.11)};
        new Solids(pillow, cloth).loft(Open.NEITHER, rings);
        return ObjectFile.bytes(List.of(pillow));
    }

    /** Across z, at height .22: a square whose sides are drawn in where it is widest. Runs from +y towards +x. */
    private static double[][] slice(double z, double half) {
        double[][] ring = new double[12][];
        int[][] across = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
        for (int k = 0; k < ring.length; k++) {
            double along = k % 3 * 2 / 3.0 - 1;
            double out = half * (1 - 0.4 * half * (1 - along * along));
            int[] d = across[k / 3];
            ring[k] = point(along * half * d[0] - out * d[1], 0.22 + along * half * d[1] + out * d[0], z);
        }
        return ring;
    }

    /** A wooden chair with a round-edged seat. */
    static byte[] chair() {
        Layer chair = new Layer("chair");
        Solids wood = new Solids(chair, Palette.BEECH);
        wood.loft(Open.NEITHER, Rings.rounded(-0.20, -0.20, 0.20, 0.20, 0.435, 0.05),
                Rings.rounded(-0.215, -0.215, 0.215, 0.215, 0.45, 0.06),
                        Rings.rounded(-0.21, -0.21, 0.21, 0.21, 0.465, 0.06));
        for (int side = -1; side <= 1; side += 2) {
            wood.leg(point(side * 0.20, 0, -0.20), point(side * 0.15, 0.435, -0.15), 0.035);
            wood.leg(point(side * 0.20, 0, 0.22), point(side * 0.15, 0.435, 0.15), 0.035);
            wood.loft(Open.FIRST, Rings.rectangle(side * 0.165 - 0.011, 0.155, side * 0.165 + 0.011, 0.177, 0.465),
                    Rings.rectangle(side * 0.165 - 0.011, 0.225, side * 0.165 + 0.011, 0.247, 0.815));
        }
        wood.loft(Open.BOTH, backRest(-0.154), backRest(0.154));
        return ObjectFile.bytes(List.of(chair));
    }

    /** Section of the board between the posts, as slanting as they. */
    private static double[][] backRest(double x) {
        return new double[][] {{x, 0.63, 0.206}, {x, 0.80, 0.240}, {x, 0.80, 0.230}, {x, 0.63, 0.196}};
    }
}
