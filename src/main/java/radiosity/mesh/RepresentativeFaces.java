package radiosity.mesh;

import java.util.Arrays;
import java.util.List;

/**
 * Groups neighbouring small faces with similar normals; in the prediction of light one face represents each group, as a
 * row of the linear system for every face of a finely modelled object would be too much.
 */
public final class RepresentativeFaces {

    /** Approximate number of representative faces for the small faces of a scene. */
    private static final int LEADERS = 4000;
    /** Least number of faces in a full group, the representative included. */
    private static final int LEAST = 4;
    /** Number of classes of normals: along +x, -x, +y, -y, +z or -z, by the largest component. */
    private static final int WAYS = 6;

    private final Patcher patcher;
    /** 1 per face: the face that represents it, often the face itself. */
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

    /** The face that represents a face; mostly the face itself. */
    public int leader(int face) {
        return leader[face];
    }

    /** Number of faces that are represented by another face. */
    public int followers() {
        return followers;
    }
}
