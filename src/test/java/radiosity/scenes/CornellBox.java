package radiosity.scenes;

import java.util.List;

/**
 * The Cornell box with the published dimensions, about 556 x 549 x 559 mm.
 *
 * <p>Source: Cornell University Program of Computer Graphics, "Cornell Box Data",
 * http://www.graphics.cornell.edu/online/box/data.html, 2 February 2005. The corners below stand as published. They
 * are right-handed: the camera looks along +z with +y up and has x = 0 and the green wall at its right. LightWave is
 * left-handed, so x becomes 556 - x, which puts the green wall at the right there too and leaves the published camera
 * (278, 273, -800) where it is. Seen from the visible side the published corners run counter-clockwise and LightWave's
 * clockwise, so the order is reversed.
 *
 * <p>The published ceiling covers the light, with the remark that it has a hole there: here it is four trapezoids
 * around the light, which meet the walls, each other and the light in whole edges.
 */
final class CornellBox {

    private static final double WIDTH = 556;

    private static final double[][] FLOOR = {{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}};
    private static final double[][] LIGHT = {{343, 548.8, 227}, {343, 548.8, 332}, {213, 548.8, 332},
            {213, 548.8, 227}};
    private static final double[][] CEILING = {{556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}};
    private static final double[][] BACK = {{549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2}};
    private static final double[][] RIGHT = {{0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}};
    /** Not planar, as published: its floor edge runs outwards, its ceiling edge does not. */
    private static final double[][] LEFT = {{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}, {556, 548.8, 0}};

    private static final double[][] SHORT_TOP = {{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}};
    private static final double[][] TALL_TOP = {{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}};

    private CornellBox() {
    }

    /** Layer 1 the box, 2 the short block, 3 the tall block. */
    static byte[] object() {
        return ObjectFile.bytes(List.of(box(), block("short block", SHORT_TOP), block("tall block", TALL_TOP)));
    }

    /** The scene of the first layers of cornell-box.lwo. */
    static byte[] scene(int layers) {
        SceneText scene = new SceneText();
        for (int layer = 1; layer <= layers; layer++) {
            scene.instance("cornell-box.lwo", layer, SceneText.Place.at(0, 0, 0));
        }
        double focalLength = 0.035;
        double film = 0.025;
        return scene.seenFrom(SceneText.Place.at(278, 273, -800), 2 * focalLength / film, 512, 512);
    }

    private static Layer box() {
        Layer box = new Layer("box");
        add(box, CornellSpectra.white(), FLOOR);
        add(box, CornellSpectra.white(), BACK);
        add(box, CornellSpectra.green(), RIGHT);
        add(box, CornellSpectra.red(), LEFT);
        for (int k = 0; k < 4; k++) {
            int next = (k + 1) % 4;
            add(box, CornellSpectra.white(), CEILING[k], CEILING[next], LIGHT[next], LIGHT[k]);
        }
        add(box, CornellSpectra.light(), LIGHT);
        return box;
    }

    /** A block without a bottom, which the floor would cover. */
    private static Layer block(String name, double[][] top) {
        Layer block = new Layer(name);
        add(block, CornellSpectra.white(), top);
        for (int k = 0; k < 4; k++) {
            double[] a = top[k];
            double[] b = top[(k + 1) % 4];
            add(block, CornellSpectra.white(), b, a, new double[] {a[0], 0, a[2]}, new double[] {b[0], 0, b[2]});
        }
        return block;
    }

    /** Adds a polygon given in published coordinates and order. */
    private static void add(Layer layer, Material material, double[]... published) {
        int n = published.length;
        double[][] corners = new double[n][];
        for (int k = 0; k < n; k++) {
            double[] p = published[n - 1 - k];
            corners[k] = new double[] {WIDTH - p[0], p[1], p[2]};
        }
        layer.polygon(material, corners);
    }
}
