package radiosity.testkit;

import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.util.Hash;

/**
 * Edits of the coloured room one after another, of four kinds in turn: a block moves, a wall is painted, the lamp has
 * another colour, a stool comes somewhere or goes.
 */
public final class RandomEdits {

    private static final int KINDS = 4;
    /** Stands before the lamp, where the block never comes. */
    private static final Prism STOOL = new Prism(0.12, new double[] {.38, .06, .38, .13, .45, .13, .45, .06});

    private RandomEdits() { }

    /** The room after a number of edits; it begins without a stool. What an edit does follows from its number. */
    public static Scene room(int edits) {
        Scene scene = withStool();
        for (int kind = 0; kind < KINDS; kind++) {
            int last = edits - Math.floorMod(edits - kind, KINDS);
            long dice = Hash.mix(7, last);
            double u = (dice >>> 40) * 0x1p-24;
            double v = (dice >>> 16 & 0xffffff) * 0x1p-24;
            scene = switch (kind) {
                case 0 -> last < 1 ? scene
                        : Edits.moved(scene, Edits.surface(scene, "block"), new Vec3(-.07 * u, 0, .25 * v));
                case 1 -> last < 1 ? scene : Edits.with(scene, "wall " + last / KINDS % 6,
                        s -> new Surface(s.name(), s.exitance(), new Rgb(.2 + .6 * u, .2 + .6 * v, .5), false));
                case 2 -> last < 1 ? scene : Edits.with(scene, "lamp",
                        s -> new Surface(s.name(), new Rgb(.7 + .6 * u, 1, .7 + .6 * v), s.reflectance(), false));
                default -> last % (2 * KINDS) == KINDS - 1
                        ? Edits.moved(scene, Edits.surface(scene, "stool"), new Vec3(.06 * u, 0, .06 * v))
                        : Edits.without(scene, Edits.surface(scene, "stool"));
            };
        }
        return scene;
    }

    private static Scene withStool() {
        SceneBuilder builder = new SceneBuilder();
        ColouredRoom.addTo(builder);
        STOOL.addTo(builder, new Surface("stool", Rgb.BLACK, new Rgb(.6, .3, .2), false));
        return builder.scene("coloured room");
    }
}
