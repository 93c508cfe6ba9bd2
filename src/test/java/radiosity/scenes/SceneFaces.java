package radiosity.scenes;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/** What a carefully modelled scene must not have, found by looking at all pairs of its triangles. */
final class SceneFaces {

    private final Scene scene;
    /** Lengths below this are nothing, scene units. */
    private final double tolerance;
    /** Unit vectors, 1 per triangle. */
    private final Vec3[] normals;
    /** Mean of the corners, and the distance from there to the farthest of them; 1 per triangle. */
    private final Vec3[] centres;
    private final double[] radii;

    SceneFaces(Scene scene, double tolerance) {
        this.scene = scene;
        this.tolerance = tolerance;
        normals = new Vec3[scene.triangles()];
        centres = new Vec3[normals.length];
        radii = new double[normals.length];
        for (int t = 0; t < normals.length; t++) {
            Vec3 a = scene.corner(t, 0);
            Vec3 b = scene.corner(t, 1);
            Vec3 c = scene.corner(t, 2);
            normals[t] = b.minus(a).cross(c.minus(a)).unit();
            centres[t] = a.plus(b).plus(c).times(1 / 3.0);
            radii[t] = Math.max(distance(t, a), Math.max(distance(t, b), distance(t, c)));
        }
    }

    private double distance(int t, Vec3 p) {
        return centres[t].minus(p).length();
    }

    private boolean near(int t, int u) {
        return distance(t, centres[u]) < radii[t] + radii[u] + tolerance;
    }

    /** Edges of one-sided triangles that neither a neighbour shares nor another triangle covers all along. */
    List<String> openEdges() {
        Set<List<Vec3>> edges = new HashSet<>();
        for (int t = 0; t < scene.triangles(); t++) {
            for (int k = 0; k < 3; k++) {
                edges.add(List.of(scene.corner(t, k), scene.corner(t, (k + 1) % 3)));
            }
        }
        List<String> open = new ArrayList<>();
        for (int t = 0; t < scene.triangles(); t++) {
            for (int k = 0; k < 3 && !scene.surface(t).twoSided(); k++) {
                Vec3 a = scene.corner(t, k);
                Vec3 b = scene.corner(t, (k + 1) % 3);
                if (!edges.contains(List.of(b, a)) && !covered(a, b, t)) {
                    open.add(scene.surface(t).name() + ": " + a + " " + b);
                }
            }
        }
        return open;
    }

    private boolean covered(Vec3 a, Vec3 b, int owner) {
        for (double s = 0.05; s < 1; s += 0.15) {
            Vec3 p = a.times(1 - s).plus(b.times(s));
            boolean found = false;
            for (int t = 0; t < scene.triangles() && !found; t++) {
                found = t != owner && contains(t, p);
            }
            if (!found) {
                return false;
            }
        }
        return true;
    }

    private boolean contains(int t, Vec3 p) {
        boolean inside = Math.abs(normals[t].dot(p.minus(scene.corner(t, 0)))) < tolerance;
        for (int k = 0; k < 3 && inside; k++) {
            inside = beyond(t, k, p) < tolerance;
        }
        return inside;
    }

    /** By how much a point lies outside of edge k of a triangle, in its plane. */
    private double beyond(int t, int k, Vec3 p) {
        Vec3 a = scene.corner(t, k);
        Vec3 along = scene.corner(t, (k + 1) % 3).minus(a);
        return along.cross(normals[t]).dot(p.minus(a)) / along.length();
    }

    /** Pairs of triangles that lie on each other. */
    List<String> coincidentFaces() {
        List<String> pairs = new ArrayList<>();
        for (int t = 0; t < scene.triangles(); t++) {
            for (int u = 0; u < t; u++) {
                if (near(t, u) && inOnePlane(t, u) && !apart(t, u) && !apart(u, t)) {
                    pairs.add(scene.surface(t).name() + " on " + scene.surface(u).name() + " at " + scene.corner(t, 0));
                }
            }
        }
        return pairs;
    }

    /** Triangles through whose inside an edge of another one goes. */
    List<String> crossings() {
        List<String> pairs = new ArrayList<>();
        for (int t = 0; t < scene.triangles(); t++) {
            for (int u = 0; u < scene.triangles(); u++) {
                for (int k = 0; k < 3 && near(t, u); k++) {
                    if (crosses(scene.corner(u, k), scene.corner(u, (k + 1) % 3), t)) {
                        pairs.add(scene.surface(u).name() + " through " + scene.surface(t).name() + " at "
                                + scene.corner(u, k));
                    }
                }
            }
        }
        return pairs;
    }

    private boolean crosses(Vec3 a, Vec3 b, int t) {
        double before = normals[t].dot(a.minus(scene.corner(t, 0)));
        double after = normals[t].dot(b.minus(scene.corner(t, 0)));
        if (before * after >= 0 || Math.min(Math.abs(before), Math.abs(after)) < 10 * tolerance) {
            return false;
        }
        Vec3 p = a.plus(b.minus(a).times(before / (before - after)));
        return beyond(t, 0, p) < -10 * tolerance && beyond(t, 1, p) < -10 * tolerance
                && beyond(t, 2, p) < -10 * tolerance;
    }

    private boolean inOnePlane(int t, int u) {
        boolean within = true;
        for (int k = 0; k < 3 && within; k++) {
            within = Math.abs(normals[t].dot(scene.corner(u, k).minus(scene.corner(t, 0)))) < tolerance;
        }
        return within;
    }

    /** Some edge of the first has the second on its outer side. */
    private boolean apart(int t, int u) {
        for (int k = 0; k < 3; k++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int corner = 0; corner < 3; corner++) {
                nearest = Math.min(nearest, beyond(t, k, scene.corner(u, corner)));
            }
            if (nearest > -2 * tolerance) {
                return true;
            }
        }
        return false;
    }
}
