package radiosity.mesh.face;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/** The points of a scene and the points that cutting adds; points that nearly coincide get one number. */
public final class CutPoints {

    /** Edge of a grid cell, in units of the distance within which points are one: most searches visit one cell only. */
    private static final double CELL = 16;

    private final double[] old;
    private final double same;
    private final List<Vec3> added = new ArrayList<>();
    /** Grid cells that hold used points. */
    private final LongIndex cells = new LongIndex(16);
    /** 1 per cell: index in {@link #known} of the point that was added last; -1 where there is none. */
    private int[] last = new int[0];
    /** Numbers of the used points in the order of first use, and per point the index of the one before in its cell. */
    private final List<Integer> known = new ArrayList<>();
    private final List<Integer> before = new ArrayList<>();
    /** Number of points whose distance was measured; read by tests. */
    public long looks;

    /** @param same largest distance between points that are one, scene units */
    public CutPoints(Scene scene, double same) {
        old = scene.points();
        this.same = same;
    }

    public Vec3 at(int number) {
        int i = 3 * number;
        return i < old.length ? new Vec3(old[i], old[i + 1], old[i + 2]) : added.get(number - old.length / 3);
    }

    /** Marks a point of the scene as used, unless a used point is at the same place. */
    public void use(int number) {
        if (find(at(number)) < 0) {
            keep(number);
        }
    }

    /** The number of the used point at a place; a new point is added where there is none. */
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

    /** Grid cell of a coordinate, counted from the scene's first point, so that it is small wherever the scene lies. */
    private long cell(double coordinate, int axis) {
        return (long) Math.floor((coordinate - old[axis]) / (CELL * same));
    }

    private static long key(long x, long y, long z) {
        return Hash.mix(Hash.mix(x, y), z);
    }

    /** The number of the point at a place; of several the one with the lowest x, then the first used; -1 for none. */
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

    /** Index in {@link #known} of the best point at a place: the best so far ({@code so}, or -1) or one of a cell. */
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
