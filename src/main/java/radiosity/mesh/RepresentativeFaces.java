package radiosity.mesh;

import java.util.Arrays;
import java.util.List;

/**
 * Small faces that are neighbours and look the same way, of which one stands for all where light is predicted: of
 * what was modelled finer than light needs, there are too many to ask each.
 */
public final class RepresentativeFaces {

    /** Faces that stand for others, about. */
    private static final int LEADERS = 4000;
    /** Faces that one stands for, at least. */
    private static final int LEAST = 4;
    /** Ways to look: along x, y or z, up or down. */
    private static final int WAYS = 6;

    private final Patcher patcher;
    /** 1 per face. */
    private final int[] leader;
    private final int most;
    private int followers;

    public RepresentativeFaces(Patcher patcher, List<Block> blocks) {
        this.patcher = patcher;
        leader = new int[patcher.faces().count()];
        int points = 0;
        for (int f = 0; f < leader.length; f++) {
            leader[f] = f;
            points += patcher.isPoint(f) ? 1 : 0;
        }
        most = Math.max(LEAST, points / LEADERS);
        blocks.forEach(this::join);
    }

    private void join(Block block) {
        int[] first = new int[WAYS];
        int[] size = new int[WAYS];
        Arrays.fill(size, most);
        for (int f : block.face()) {
            if (!patcher.isPoint(f)) {
                continue;
            }
            int way = way(f);
            if (size[way] == most) {
                first[way] = f;
                size[way] = 0;
            }
            followers += size[way] > 0 ? 1 : 0;
            size[way]++;
            leader[f] = first[way];
        }
    }

    private int way(int face) {
        int along = 0;
        for (int a = 1; a < 3; a++) {
            along = Math.abs(patcher.faces().normal(face, a)) > Math.abs(patcher.faces().normal(face, along)) ? a
                    : along;
        }
        return 2 * along + (patcher.faces().normal(face, along) < 0 ? 1 : 0);
    }

    /** The face that stands for one: mostly itself. */
    public int leader(int face) {
        return leader[face];
    }

    /** Faces for which another one stands. */
    public int followers() {
        return followers;
    }
}
