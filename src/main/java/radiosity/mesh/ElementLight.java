package radiosity.mesh;

import java.util.Arrays;
import radiosity.mesh.face.Subdivision;
import radiosity.util.ArraySize;

/**
 * The light on the elements of some patch trees: what has arrived at their vertices, and what they have shot.
 *
 * <p>Between the corners of an element all of it is linear.
 */
public final class ElementLight {

    private final RadiosityNodes nodes;
    private final NodeTree tree;
    private final ReceivingPoints points;
    private final int channels;
    /** 3 x channels per element, by its place: radiosity S that has been shot at each corner. W/m². */
    private double[] shot;

    ElementLight(RadiosityNodes nodes, NodeTree tree, ReceivingPoints points) {
        this.nodes = nodes;
        this.tree = tree;
        this.points = points;
        channels = nodes.channels();
        shot = new double[size(channels, tree.elements())];
    }

    /**
     * How many numbers say what elements have shot.
     *
     * @throws radiosity.util.TooLargeException where they are more than an array holds
     */
    static int size(int channels, long elements) {
        return ArraySize.of(what(channels), 3, channels, elements);
    }

    private static String what(int channels) {
        return "light shot by elements in " + channels + " channels";
    }

    /** Makes room for about this number of divided elements more. */
    void expect(int divided) {
        int each = 3 * channels;
        makeRoom(each * ArraySize.room(what(channels), tree.elements(), tree.elements() + 3L * divided, each));
    }

    private void makeRoom(int room) {
        if (room > shot.length) {
            shot = Arrays.copyOf(shot, room);
        }
    }

    /** Gives four children what their parent had shot. */
    void divide(int node, int first) {
        int n = 3 * channels;
        double[] before = Arrays.copyOfRange(shot, n * tree.place(node), n * (tree.place(node) + 1));
        if ((long) n * tree.elements() > shot.length) {
            makeRoom(n * ArraySize.room(what(channels), tree.elements(), shot.length / n / 4 * 5L, n));
        }
        for (int k = 0; k < 4; k++) {
            System.arraycopy(Subdivision.values(before, channels, k), 0, shot, n * tree.place(first + k), n);
        }
    }

    /** H, channels per vertex, W/m²; whoever owns the tree adds to it. */
    public double[] irradiance() {
        return points.irradiance();
    }

    /** Irradiance H at corner k of an element, W/m²: that of its vertex, or the mean of the others if it is buried. */
    public double irradiance(int node, int k, int channel) {
        int v = tree.corner(node, k);
        return points.isBuried(v) ? ofOthers(node, channel) : arrived(v, channel);
    }

    /** The mean over those corners that are not buried, W/m². */
    private double ofOthers(int node, int channel) {
        double sum = 0;
        int seen = 0;
        for (int j = 0; j < 3; j++) {
            int v = tree.corner(node, j);
            if (!points.isBuried(v)) {
                sum += arrived(v, channel);
                seen++;
            }
        }
        return seen == 0 ? 0 : sum / seen;
    }

    /**
     * By how much the mean of H over an element exceeds that of its corners, W/m²: where light is curved, straight
     * lines between vertices lose some. It takes away no more than the corners have in the mean.
     *
     * <p>Seen from its parent (L. F. Richardson, The deferred approach to the limit, 1927): an edge of half the length
     * bulges a quarter as much, and the mean over a parabolic triangle is a third of the sum of its edges' bulges.
     */
    public double bulge(int node, int channel) {
        double sum = 0;
        int parent = tree.parent(node);
        for (int k = 0; k < 3 && parent >= 0; k++) {
            sum += bulge(parent, k, channel);
        }
        return sum >= 0 ? sum / 12 : Math.max(sum / 12, -Math.max(0, mean(node, channel)));
    }

    /** The mean of H over the corners of an element, W/m². */
    private double mean(int node, int channel) {
        return (irradiance(node, 0, channel) + irradiance(node, 1, channel) + irradiance(node, 2, channel)) / 3;
    }

    /** The least H at a corner of an element, W/m². */
    private double least(int node, int channel) {
        return Math.min(irradiance(node, 0, channel),
                Math.min(irradiance(node, 1, channel), irradiance(node, 2, channel)));
    }

    /**
     * By what part of themselves the differences of H between the corners of an element count where H and its bulge are
     * reflected, in [0, 1]: less than 1 where a corner would reflect less than nothing otherwise. The mean stays the
     * same (X. Zhang, C.-W. Shu, On maximum-principle-satisfying high order schemes for scalar conservation laws,
     * 2010).
     */
    private double slope(int node, int channel, double bulge) {
        double least = least(node, channel);
        double mean = mean(node, channel);
        return least + bulge >= 0 || mean + bulge < 0 ? 1 : (mean + bulge) / (mean - least);
    }

    /** H at the middle of the edge opposite corner k of an inner node less the mean of the edge's ends, W/m². */
    private double bulge(int node, int k, int channel) {
        int p = tree.corner(node, (k + 1) % 3);
        int q = tree.corner(node, (k + 2) % 3);
        int middle = tree.corner(tree.child(node) + 3, k);
        if (points.isBuried(p) || points.isBuried(q) || points.isBuried(middle)) {
            return 0;
        }
        return arrived(middle, channel) - 0.5 * (arrived(p, channel) + arrived(q, channel));
    }

    private double arrived(int vertex, int channel) {
        return points.irradiance()[channels * vertex + channel];
    }

    /** Radiosity B = E + rho H (equation 1) at corner k of an element, W/m². */
    public double radiosity(int node, int k, int channel) {
        return nodes.exitance(node, channel) + nodes.reflectance(node, channel) * irradiance(node, k, channel);
    }

    /** Radiosity S that was shot at corner k of an element, W/m². */
    public double shot(int node, int k, int channel) {
        return shot[channels * (3 * tree.place(node) + k) + channel];
    }

    /** The same at all corners, see {@link PatchTree.Quantity}. */
    public void shot(int node, double[] values, int at) {
        System.arraycopy(shot, 3 * channels * tree.place(node), values, at, 3 * channels);
    }

    /** Sets S at corner k of an element, W/m²; for whoever owns the tree. */
    public void setShot(int node, int k, int channel, double radiosity) {
        shot[channels * (3 * tree.place(node) + k) + channel] = radiosity;
    }

    /** What was shot and what is unshot, at all corners, W/m²; see {@link PatchTree.Quantity}. */
    public void leaving(int node, double[] values, int at) {
        unshot(node, values, at);
        for (int i = 0; i < 3 * channels; i++) {
            values[at + i] += shot[3 * channels * tree.place(node) + i];
        }
    }

    /**
     * Unshot radiosity U = B - S, the element's bulge included, at corner k of an element, W/m²; signed. Of the mean
     * over the corners: what is shot at each of them is said below.
     *
     * @param bulge of the element in this channel
     */
    public double unshot(int node, int k, int channel, double bulge) {
        return radiosity(node, k, channel) - shot(node, k, channel) + nodes.reflectance(node, channel) * bulge;
    }

    /**
     * What is to be shot for all that was ever shot to be what leaves the corners, and no less than nothing: a vertex
     * that has received less than nothing, as later shots took back along other rays, radiates nothing.
     */
    public void unshotOfPositive(int node, double[] values, int at) {
        unshot(node, values, at);
        for (int i = 0; i < 3 * channels; i++) {
            values[at + i] = Math.max(values[at + i], -shot[3 * channels * tree.place(node) + i]);
        }
    }

    /** What is to be shot at all corners: no corner reflects less than nothing. See {@link PatchTree.Quantity}. */
    public void unshot(int node, double[] values, int at) {
        for (int c = 0; c < channels; c++) {
            double exitance = nodes.exitance(node, c);
            double reflectance = nodes.reflectance(node, c);
            double bulge = bulge(node, c);
            double slope = slope(node, c, bulge);
            double level = slope == 1 ? bulge : bulge + (1 - slope) * mean(node, c);
            for (int k = 0; k < 3; k++) {
                values[at + channels * k + c] = exitance
                        + reflectance * slope * irradiance(node, k, c) - shot(node, k, c)
                        + reflectance * level;
            }
        }
    }
}
