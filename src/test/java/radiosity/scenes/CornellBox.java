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
        return ObjectFile.bytes(List.of(box(), block("short block", CornellSpectra.white(), SHORT_TOP, 0),
                block("tall block", CornellSpectra.white(), TALL_TOP, 0)));
    }

    /**
     * What makes a room with a mirror and glass of it. Layer 1 a front wall, through whose back the camera looks, 2 the
     * tall block as a mirror, 3 a glass block that stands on the short one.
     */
    static byte[] mirrors() {
        Layer front = new Layer("front").facing(Material.paint("blue", .25, .35, .6), new double[] {0, 0, 1},
                new double[] {WIDTH - 552.8, 0, 0}, new double[] {0, 548.8, 0}, new double[] {WIDTH, 548.8, 0},
                new double[] {WIDTH, 0, 0});
        return ObjectFile.bytes(List.of(front, block("mirror", Material.mirror("mirror", .9), TALL_TOP, 0),
                block("glass", Material.glass("glass", 1.5), glass(), 165)));
    }

    /** The top of the short block, smaller and higher. */
    private static double[][] glass() {
        double[][] top = new double[4][];
        for (int k = 0; k < 4; k++) {
            top[k] = new double[] {185.5 + .65 * (SHORT_TOP[k][0] - 185.5), 165 + 110,
                    169 + .65 * (SHORT_TOP[k][2] - 169)};
        }
        return top;
    }

    /** The scene of the first layers of cornell-box.lwo, and, if so, of those of cornell-mirror.lwo. */
    static byte[] scene(int layers, boolean mirrors) {
        SceneText scene = new SceneText();
        for (int layer = 1; layer <= layers; layer++) {
            scene.instance("cornell-box.lwo", layer, SceneText.Place.at(0, 0, 0));
        }
        for (int layer = 1; layer <= 3 && mirrors; layer++) {
            scene.instance("cornell-mirror.lwo", layer, SceneText.Place.at(0, 0, 0));
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

    /**
     * A block without a bottom, which the floor would cover.
     *
     * @param floor height of the floor on which it stands
     */
    private static Layer block(String name, Material material, double[][] top, double floor) {
        Layer block = new Layer(name);
        add(block, material, top);
        for (int k = 0; k < 4; k++) {
            double[] a = top[k];
            double[] b = top[(k + 1) % 4];
            add(block, material, b, a, new double[] {a[0], floor, a[2]}, new double[] {b[0], floor, b[2]});
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
