package radiosity.mesh.face;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/** The points of a scene, and those that cutting adds; what is as good as one place has one number. */
public final class CutPoints {

    /** Edge of a cell, of the distance within which points are one: most points reach into one cell only. */
    private static final double CELL = 16;

    private final double[] old;
    private final double same;
    private final List<Vec3> added = new ArrayList<>();
    /** Cells of space that hold points which were used so far. */
    private final LongIndex cells = new LongIndex(16);
    /** 1 per cell: place in the list below of the point that came last; -1 where there is none. */
    private int[] last = new int[0];
    /**
     * Points that were used so far, in their order: their numbers, and the place of the one before in the same cell.
     */
    private final List<Integer> known = new ArrayList<>();
    private final List<Integer> before = new ArrayList<>();
    /** Points whose distances were measured, for tests. */
    public long looks;

    /** @param same points nearer to each other than this are one, scene units */
    public CutPoints(Scene scene, double same) {
        old = scene.points();
        this.same = same;
    }

    public Vec3 at(int number) {
        int i = 3 * number;
        return i < old.length ? new Vec3(old[i], old[i + 1], old[i + 2]) : added.get(number - old.length / 3);
    }

    /** A point of the scene will be used. */
    public void use(int number) {
        if (find(at(number)) < 0) {
            keep(number);
        }
    }

    /** The number of a point; it is added where none is there yet. */
    public int number(Vec3 p) {
        int found = find(p);
        if (found >= 0) {
            return found;
        }
        added.add(p);
        int number = old.length / 3 + added.size() - 1;
        keep(number);
        return number;
    }

    private void keep(int number) {
        Vec3 p = at(number);
        int cell = cells.findOrAdd(key(cell(p.x(), 0), cell(p.y(), 1), cell(p.z(), 2)), cells.size());
        if (cell == last.length) {
            last = Arrays.copyOf(last, Math.max(16, 2 * cell));
            Arrays.fill(last, cell, last.length, -1);
        }
        before.add(last[cell]);
        last[cell] = known.size();
        known.add(number);
    }

    /** Counted from the scene's first point, so that it is a small number however far away the scene lies. */
    private long cell(double coordinate, int axis) {
        return (long) Math.floor((coordinate - old[axis]) / (CELL * same));
    }

    private static long key(long x, long y, long z) {
        return Hash.mix(Hash.mix(x, y), z);
    }

    /**
     * Of the points that are one with a place that with the lowest x, and of equal ones the first used; -1 for none.
     */
    private int find(Vec3 p) {
        int found = -1;
        for (long x = cell(p.x() - same, 0); x <= cell(p.x() + same, 0); x++) {
            for (long y = cell(p.y() - same, 1); y <= cell(p.y() + same, 1); y++) {
                for (long z = cell(p.z() - same, 2); z <= cell(p.z() + same, 2); z++) {
                    found = better(found, cells.find(key(x, y, z)), p);
                }
            }
        }
        return found < 0 ? -1 : known.get(found);
    }

    /** The better of a place in the list and those in a cell. */
    private int better(int so, int cell, Vec3 p) {
        int best = so;
        for (int i = cell < 0 ? -1 : last[cell]; i >= 0; i = before.get(i)) {
            looks++;
            Vec3 q = at(known.get(i));
            if (q.minus(p).length() <= same) {
                int order = best < 0 ? -1 : Double.compare(q.x(), at(known.get(best)).x());
                best = order < 0 || order == 0 && i < best ? i : best;
            }
        }
        return best;
    }

    public Vec3 middle(int p, int q) {
        return at(p).plus(at(q)).times(0.5);
    }
}
