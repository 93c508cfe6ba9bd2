package radiosity.visibility;

import java.util.stream.IntStream;

/**
 * Moves the largest boxes of a tree to the places at which the areas of all boxes together are least.
 *
 * <p>Building from the top down finds no good place for large triangles among small ones, such as the walls around a
 * mesh. Only boxes near the root are moved: every ray tests them, and there are few. Sources: J. Bittner, M. Hapala, V.
 * Havran, Fast insertion-based optimization of bounding volume hierarchies, 2013; the search: D. Meister, J. Bittner,
 * Parallel reinsertion for bounding volume hierarchy optimization, 2018.
 */
final class Reinsertion {

    /** Largest number of boxes that take part. */
    private static final int BOXES = 2001;
    private static final int PASSES = 3;
    /** Least reduction of the sum of areas for which a box is moved, relative to the root's area. */
    private static final float LEAST_GAIN = 1e-6f;

    private final TopLevelBvh top;
    /** Number of a box that is no part of the tree, for scratch. */
    private final int spare;
    /** Best place found so far for the present box, or -1, and the reduction of the sum of areas there. */
    private int place;
    private float gain;

    private Reinsertion(TopLevelBvh top) {
        this.top = top;
        spare = top.boxes;
    }

    /** A tree over the same boxes that rays pass more quickly, or the given tree where no box is moved. */
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

    /** Tries to move every box once, the largest first; returns the number of boxes moved. */
    private int pass() {
        int moved = 0;
        for (int i : IntStream.range(1, top.boxes).boxed().sorted(top::byArea).toList()) {
            moved += move(i) ? 1 : 0;
        }
        return moved;
    }

    /** Moves a box to its best place, if there is a better one. The root and its two children stay. */
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

    /** Finds the best place for box i: searches its sibling's subtree, then its parent's sibling's, up to the root. */
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
     * Searches a subtree for a better place of box i.
     *
     * @param at    root of the subtree
     * @param saved reduction of the sum of areas without the new box around box i and its sibling-to-be
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
