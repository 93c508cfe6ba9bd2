package radiosity.visibility;

import java.util.stream.IntStream;

/**
 * Moves the largest boxes of a tree to where those around them grow least.
 *
 * <p>Parting from above finds no good place for large triangles among small ones, such as the walls around a mesh.
 * Boxes near the root cost every ray, and there are few of them, so this takes next to no time. Sources: J. Bittner, M.
 * Hapala, V. Havran, Fast insertion-based optimization of bounding volume hierarchies, 2013; the search: D. Meister, J.
 * Bittner, Parallel reinsertion for bounding volume hierarchy optimization, 2018.
 */
final class Reinsertion {

    private static final int BOXES = 2001;
    private static final int PASSES = 3;
    /** Less than this of the root's area is no gain. */
    private static final float LEAST_GAIN = 1e-6f;

    private final TopLevelBvh top;
    private final int spare;
    /** Where the box that is looked at is best, so far, and by how much all areas together are then less. */
    private int place;
    private float gain;

    private Reinsertion(TopLevelBvh top) {
        this.top = top;
        spare = top.boxes;
    }

    /** A tree that rays pass more quickly, or the same one. */
    static BoundsTree improve(BoundsTree tree) {
        if (tree.nodes == 0) {
            return tree;
        }
        Reinsertion reinsertion = new Reinsertion(new TopLevelBvh(tree, BOXES));
        int moved = 0;
        for (int pass = 0; pass < PASSES; pass++) {
            moved += reinsertion.pass();
        }
        return moved > 0 ? reinsertion.top.write() : tree;
    }

    private int pass() {
        int moved = 0;
        for (int i : IntStream.range(1, top.boxes).boxed().sorted(top::byArea).toList()) {
            moved += move(i) ? 1 : 0;
        }
        return moved;
    }

    /** The root and what is directly in it stay. */
    private boolean move(int i) {
        if (top.parent[i] <= 0) {
            return false;
        }
        find(i);
        if (place >= 0) {
            top.move(i, place);
        }
        return place >= 0;
    }

    /** Looks beside the box, beside the one around it, and so on to the root. */
    private void find(int i) {
        place = -1;
        gain = LEAST_GAIN * top.area[0];
        int around = top.parent[i];
        int side = top.beside(i);
        float saved = top.area[around];
        top.enclose(spare, side, side);
        look(side, i, saved);
        while (around != 0) {
            side = top.beside(around);
            look(side, i, saved);
            around = top.parent[around];
            top.enclose(spare, spare, side);
            saved += top.area[around] - top.area[spare];
        }
    }

    /**
     * Looks for a place in a box.
     *
     * @param saved by how much all areas are less before what is in the box is put together with box i
     */
    private void look(int at, int i, float saved) {
        if (saved - top.area[i] <= gain) {
            return;
        }
        float around = top.around(at, i);
        if (saved - around > gain) {
            gain = saved - around;
            place = at;
        }
        if (top.left[at] >= 0) {
            look(top.left[at], i, saved + top.area[at] - around);
            look(top.right[at], i, saved + top.area[at] - around);
        }
    }
}
