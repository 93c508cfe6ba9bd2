package radiosity.patch;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/** The points of a scene, and those that cutting adds; what is as good as one place has one number. */
final class CutPoints {

    private final double[] old;
    private final double same;
    private final List<Vec3> added = new ArrayList<>();
    /** Numbers of points that were used so far, by x. */
    private final TreeMap<Double, List<Integer>> known = new TreeMap<>();

    /** @param same points nearer to each other than this are one, scene units */
    CutPoints(Scene scene, double same) {
        old = scene.points();
        this.same = same;
    }

    Vec3 at(int number) {
        int i = 3 * number;
        return i < old.length ? new Vec3(old[i], old[i + 1], old[i + 2]) : added.get(number - old.length / 3);
    }

    /** A point of the scene will be used. */
    void use(int number) {
        if (find(at(number)) < 0) {
            known.computeIfAbsent(at(number).x(), none -> new ArrayList<>()).add(number);
        }
    }

    /** The number of a point; it is added where none is there yet. */
    int number(Vec3 p) {
        int found = find(p);
        if (found >= 0) {
            return found;
        }
        added.add(p);
        int number = old.length / 3 + added.size() - 1;
        known.computeIfAbsent(p.x(), none -> new ArrayList<>()).add(number);
        return number;
    }

    private int find(Vec3 p) {
        for (List<Integer> some : known.subMap(p.x() - same, true, p.x() + same, true).values()) {
            for (int number : some) {
                if (at(number).minus(p).length() <= same) {
                    return number;
                }
            }
        }
        return -1;
    }

    Vec3 middle(int p, int q) {
        return at(p).plus(at(q)).times(0.5);
    }
}
