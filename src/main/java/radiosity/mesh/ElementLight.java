package radiosity.mesh;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import radiosity.mesh.face.Subdivision;
import radiosity.util.ArraySize;

/**
 * The light on the elements of some patch trees: irradiance at vertices, and radiosity shot at corners of elements.
 *
 * <p>Between the corners of an element, irradiance and radiosity are linear.
 */
public final class ElementLight {

    private final RadiosityNodes nodes;
    private final ReceivingPoints points;
    private final int channels;
    /** 3 x channels per element, in the order of {@link NodeTree#place}: radiosity S shot at each corner, W/m². */
    private double[] shot;

    ElementLight(RadiosityNodes nodes, ReceivingPoints points) {
        this.nodes = nodes;
        this.points = points;
        channels = nodes.channels();
        shot = new double[size(channels, nodes.elements())];
    }

    /**
     * Number of entries of the array of shot radiosities: 3 x channels per element.
     *
     * @throws radiosity.util.TooLargeException where an array cannot hold this number of entries
     */
    static int size(int channels, long elements) {
        return ArraySize.of(what(channels), 3, channels, elements);
    }

    private static String what(int channels) {
        return "light shot by elements in " + channels + " channels";
    }

    /** Makes room for the elements of about this number of further divisions. */
    void expect(int divided) {
        int each = 3 * channels;
        makeRoom(each * ArraySize.room(what(channels), nodes.elements(), nodes.elements() + 3L * divided, each));
    }

    private void makeRoom(int room) {
        if (room > shot.length) {
            shot = Arrays.copyOf(shot, room);
        }
    }

    /** Gives four children the radiosity that their parent had shot, interpolated at their corners. */
    void divide(int node, int first) {
        int n = 3 * channels;
        double[] before = Arrays.copyOfRange(shot, n * nodes.place(node), n * (nodes.place(node) + 1));
        if ((long) n * nodes.elements() > shot.length) {
            makeRoom(n * ArraySize.room(what(channels), nodes.elements(), shot.length / n / 4 * 5L, n));
        }
        for (int k = 0; k < 4; k++) {
            System.arraycopy(Subdivision.values(before, channels, k), 0, shot, n * nodes.place(first + k), n);
        }
    }

    /** Irradiance H, channels per vertex, W/m². Not a copy: the owner of the tree adds to this array. */
    public double[] irradiance() {
        return points.irradiance();
    }

    /** Irradiance H at corner k of an element, W/m². A buried vertex takes the mean of the element's others. */
    public double irradiance(int node, int k, int channel) {
        int v = nodes.corner(node, k);
        return points.isBuried(v) ? ofOthers(node, w -> arrived(w, channel)) : arrived(v, channel);
    }

    /** The mean of a quantity over the element's vertices that are not buried; 0 where all are buried. */
    public double ofOthers(int node, IntToDoubleFunction atVertex) {
        double sum = 0;
        int seen = 0;
        for (int j = 0; j < 3; j++) {
            int v = nodes.corner(node, j);
            if (!points.isBuried(v)) {
                sum += atVertex.applyAsDouble(v);
                seen++;
            }
        }
        return seen == 0 ? 0 : sum / seen;
    }

    /**
     * By how much the mean of H over an element exceeds the mean of H at its corners, W/m²: where irradiance is
     * curved, linear interpolation between vertices loses light. A negative bulge is at most as large as the mean of H
     * at the corners.
     *
     * <p>The bulge is extrapolated from the element's parent (L. F. Richardson, The deferred approach to the limit,
     * 1927): an edge of half the length bulges a quarter as much, and over a triangle on which H is quadratic, the mean
     * bulge is a third of the sum of the bulges of its edges. An element without parent has bulge 0.
     */
    public double bulge(int node, int channel) {
        double sum = 0;
        int parent = nodes.parent(node);
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
     * Factor in [0, 1] by which differences of H from its mean over the corners are reduced before H and the bulge are
     * reflected: less than 1 where a corner would reflect less than 0, although the mean with the bulge does not. The
     * mean stays the same (X. Zhang, C.-W. Shu, On maximum-principle-satisfying high order schemes for scalar
     * conservation laws, 2010).
     */
    private double slope(int node, int channel, double bulge) {
        double least = least(node, channel);
        double mean = mean(node, channel);
        return least + bulge >= 0 || mean + bulge < 0 ? 1 : (mean + bulge) / (mean - least);
    }

    /** Bulge of the edge opposite corner k of an inner node, W/m²: H at its middle less the mean of H at its ends. */
    private double bulge(int node, int k, int channel) {
        int p = nodes.corner(node, (k + 1) % 3);
        int q = nodes.corner(node, (k + 2) % 3);
        int middle = nodes.corner(nodes.child(node) + 3, k);
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
        return shot[channels * (3 * nodes.place(node) + k) + channel];
    }

    /** Puts the radiosity shot at an element's corners into {@code values}, see {@link PatchTree.Quantity}. W/m². */
    public void shot(int node, double[] values, int at) {
        System.arraycopy(shot, 3 * channels * nodes.place(node), values, at, 3 * channels);
    }

    /** Sets the radiosity S shot at corner k of an element, W/m²; only the owner of the tree may call this. */
    public void setShot(int node, int k, int channel, double radiosity) {
        shot[channels * (3 * nodes.place(node) + k) + channel] = radiosity;
    }

    /** Puts an element's shot plus unshot radiosity into {@code values}, see {@link PatchTree.Quantity}. W/m². */
    public void leaving(int node, double[] values, int at) {
        unshot(node, values, at);
        for (int i = 0; i < 3 * channels; i++) {
            values[at + i] += shot[3 * channels * nodes.place(node) + i];
        }
    }

    /**
     * Unshot radiosity U = B - S at corner k of an element, with the reflected bulge, W/m²; signed. Only the mean over
     * the three corners is exact: {@link #unshot(int, double[], int)} also limits the differences between corners.
     *
     * @param bulge the element's {@link #bulge(int, int)} in this channel
     */
    public double unshot(int node, int k, int channel, double bulge) {
        return radiosity(node, k, channel) - shot(node, k, channel) + nodes.reflectance(node, channel) * bulge;
    }

    /**
     * Like {@link #unshot(int, double[], int)}, but a corner from which less than 0 would leave counts as black: its
     * unshot radiosity is -S. Irradiance can be negative where later shots took light back along other rays.
     */
    public void unshotOfPositive(int node, double[] values, int at) {
        unshot(node, values, at);
        for (int i = 0; i < 3 * channels; i++) {
            values[at + i] = Math.max(values[at + i], -shot[3 * channels * nodes.place(node) + i]);
        }
    }

    /**
     * Puts an element's unshot radiosity, W/m², into {@code values}, see {@link PatchTree.Quantity}. Where the mean of
     * H with the bulge is not negative, differences between corners are reduced so that no corner reflects less than 0.
     */
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
