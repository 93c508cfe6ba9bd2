package radiosity.mesh.cut;

import java.util.ArrayList;
import java.util.List;
import radiosity.mesh.face.CutPoints;
import radiosity.scene.Vec3;

/** Cuts a convex polygon, which may have points on its edges, into triangles: the best shaped ear comes first. */
final class ConvexTriangulator {

    private final CutPoints points;
    private final Vec3 normal;

    ConvexTriangulator(CutPoints points, Vec3 normal) {
        this.points = points;
        this.normal = normal;
    }

    /** @return 3 points per triangle, counter-clockwise like the loop; a remainder without area gets no triangles */
    List<int[]> triangles(int[] loop) {
        List<Integer> left = new ArrayList<>();
        for (int p : loop) {
            left.add(p);
        }
        List<int[]> found = new ArrayList<>();
        while (left.size() >= 3) {
            int best = best(left);
            if (best < 0) {
                return found;
            }
            int n = left.size();
            found.add(new int[] {left.get((best + n - 1) % n), left.get(best), left.get((best + 1) % n)});
            left.remove(best);
        }
        return found;
    }

    /** The best ear whose removal leaves a polygon with an area, or nothing; -1 where there is none. */
    private int best(List<Integer> left) {
        int n = left.size();
        int best = -1;
        double most = 0;
        for (int i = 0; i < n; i++) {
            double quality = quality(left.get((i + n - 1) % n), left.get(i), left.get((i + 1) % n));
            if (quality > most && (n == 3 || keepsArea(left, i))) {
                most = quality;
                best = i;
            }
        }
        return best;
    }

    private boolean keepsArea(List<Integer> left, int without) {
        List<Integer> rest = new ArrayList<>(left);
        rest.remove(without);
        for (int i = 0; i < rest.size(); i++) {
            int n = rest.size();
            if (quality(rest.get((i + n - 1) % n), rest.get(i), rest.get((i + 1) % n)) > 0) {
                return true;
            }
        }
        return false;
    }

    /** Area over the sum of squared edges; 0 where that is nearly 0, negative for a triangle that is turned over. */
    private double quality(int p, int q, int r) {
        Vec3 a = points.at(q).minus(points.at(p));
        Vec3 b = points.at(r).minus(points.at(q));
        Vec3 c = points.at(p).minus(points.at(r));
        double quality = a.cross(b).dot(normal) / (a.dot(a) + b.dot(b) + c.dot(c));
        return Math.abs(quality) < 1e-9 ? 0 : quality;
    }
}
