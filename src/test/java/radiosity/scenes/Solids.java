package radiosity.scenes;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Adds solids of one material to a layer, fronts outside.
 *
 * <p>Where a solid stands on another, its face there is left open, so that no two faces lie on each other.
 */
final class Solids {

    /** The faces of a box: towards -x, +x, -y, +y, -z, +z. */
    enum Face { LEFT, RIGHT, BELOW, ABOVE, NEAR, FAR }

    /** Which ends of a loft have no lid. */
    enum Open { NEITHER, FIRST, LAST, BOTH }

    private final Layer layer;
    private final Material material;

    Solids(Layer layer, Material material) {
        this.layer = layer;
        this.material = material;
    }

    /** A box from x0, y0, z0 to x1, y1, z1 without the given faces. */
    Solids box(double x0, double y0, double z0, double x1, double y1, double z1, Face... open) {
        double[][] low = Rings.rectangle(x0, z0, x1, z1, y0);
        double[][] high = Rings.rectangle(x0, z0, x1, z1, y1);
        Face[] sides = {Face.FAR, Face.LEFT, Face.NEAR, Face.RIGHT};
        List<Face> omitted = Arrays.asList(open);
        for (int k = 0; k < 4; k++) {
            if (!omitted.contains(sides[k])) {
                side(low, high, k);
            }
        }
        if (!omitted.contains(Face.BELOW)) {
            layer.polygon(material, low);
        }
        if (!omitted.contains(Face.ABOVE)) {
            layer.polygon(material, reversed(high));
        }
        return this;
    }

    /** The inside of a box that is open towards -z. */
    Solids recess(double x0, double y0, double z0, double x1, double y1, double z1) {
        double[][] low = Rings.rectangle(x0, z0, x1, z1, y0);
        double[][] high = Rings.rectangle(x0, z0, x1, z1, y1);
        side(high, low, 0);
        side(high, low, 1);
        side(high, low, 3);
        layer.polygon(material, reversed(low));
        layer.polygon(material, high);
        return this;
    }

    /** A skin over rings of equally many points, with lids at the ends. Downwards it shows its front inside. */
    Solids loft(Open open, double[][]... rings) {
        for (int r = 1; r < rings.length; r++) {
            for (int k = 0; k < rings[r].length; k++) {
                side(rings[r - 1], rings[r], k);
            }
        }
        if (open != Open.FIRST && open != Open.BOTH) {
            layer.polygon(material, rings[0]);
        }
        if (open != Open.LAST && open != Open.BOTH) {
            layer.polygon(material, reversed(rings[rings.length - 1]));
        }
        return this;
    }

    private void side(double[][] low, double[][] high, int k) {
        int next = (k + 1) % low.length;
        layer.polygon(material, low[k], high[k], high[next], low[next]);
    }

    private static double[][] reversed(double[][] ring) {
        double[][] result = new double[ring.length][];
        for (int k = 0; k < ring.length; k++) {
            result[k] = ring[ring.length - 1 - k];
        }
        return result;
    }

    /** Turned about the vertical through x, z; the profile is radius, height, radius, height … from first to last. */
    Solids lathe(Open open, double x, double z, int n, double... profile) {
        double[][][] rings = new double[profile.length / 2][][];
        for (int r = 0; r < rings.length; r++) {
            rings[r] = Rings.circle(x, profile[2 * r + 1], z, profile[2 * r], n);
        }
        return loft(open, rings);
    }

    /** A sphere of n meridians and n / 2 bands. */
    Solids sphere(double x, double y, double z, double radius, int n) {
        double[] profile = new double[n + 2];
        for (int r = 0; r <= n / 2; r++) {
            double angle = Math.PI * (2.0 * r / n - 0.5);
            profile[2 * r] = radius * StrictMath.cos(angle);
            profile[2 * r + 1] = y + radius * StrictMath.sin(angle);
        }
        return lathe(Open.NEITHER, x, z, n, profile);
    }

    /** A round bar of six sides. */
    Solids bar(Open open, double[] from, double[] to, double radius) {
        return loft(open, Rings.across(from, to, from, radius, 6), Rings.across(from, to, to, radius, 6));
    }

    /** A square leg, half as thick at its foot, open where it meets what it carries and what it stands on. */
    Solids leg(double[] foot, double[] top, double thickness) {
        double h = thickness / 2;
        return loft(Open.BOTH,
                Rings.rectangle(foot[0] - h / 2, foot[2] - h / 2, foot[0] + h / 2, foot[2] + h / 2, foot[1]),
                Rings.rectangle(top[0] - h, top[2] - h, top[0] + h, top[2] + h, top[1]));
    }

    /**
     * An upholstered box: upright edges and upper edges rounded, the top crowned.
     *
     * @param below  the lower edges are rounded too and closed; otherwise the bottom is open
     * @param radius of the edges
     * @param crown  by how much the middle of the top is higher than y1
     */
    Solids cushion(double x0, double y0, double z0, double x1, double y1, double z1, boolean below, double radius,
            double crown) {
        List<double[][]> rings = new ArrayList<>();
        for (int k = below ? 0 : 2; k <= 4; k++) {
            double angle = Math.PI / 4 * (k - 2);
            double inset = radius * (1 - StrictMath.cos(angle));
            double y = k < 2 ? y0 + radius * (1 + StrictMath.sin(angle)) : y1 - radius * (1 - StrictMath.sin(angle));
            if (k == 2) {
                rings.add(Rings.rounded(x0, z0, x1, z1, below ? y0 + radius : y0, 1.5 * radius));
            }
            rings.add(Rings.rounded(x0 + inset, z0 + inset, x1 - inset, z1 - inset, y, 1.5 * radius - inset));
        }
        double middle = (radius + Math.min(x1 - x0, z1 - z0) / 2) / 2;
        rings.add(Rings.rounded(x0 + middle, z0 + middle, x1 - middle, z1 - middle, y1 + crown, radius / 4));
        return loft(below ? Open.NEITHER : Open.FIRST, rings.toArray(double[][][]::new));
    }
}
