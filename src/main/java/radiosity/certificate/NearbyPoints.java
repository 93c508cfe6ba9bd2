package radiosity.certificate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.face.Subdivision;
import radiosity.scene.Vec3;
import radiosity.util.Frame;
import radiosity.util.Hash;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;

/**
 * Finds points on surfaces near the points of an audit, whose errors arrive there.
 *
 * <p>Where light is gathered anew from a solution, the difference is the residual r, and the error is the sum of r,
 * K r, K^2 r and so on, with the operator K that reflects light once. Errors of surfaces far away have either sign and
 * cancel, but for their mean, see {@link AuditBias}. Errors of surfaces that are nearer than an element is large do
 * not: in the gap between a wall and the back of a cupboard both sides err alike. So the series is followed there, by
 * random walks as in path tracing: from a point one ray with the distribution of diffuse light; where it meets a
 * surface nearer than the point's element is large, the residual there counts among the light that arrives at the
 * point.
 */
final class NearbyPoints {

    /** Largest number of steps of a walk. */
    private static final int STEPS = 3;
    private static final float LIFT = (float) RadiosityBounds.LIFT;

    private final Faces faces;
    private final RadiosityBounds bounds;
    private final AuditPlaces places;
    /** 1 per original triangle: one of the faces on it, or -1; 1 per face: another face on its triangle, or -1. */
    private final int[] first;
    private final int[] next;

    /**
     * A place on a face.
     *
     * @param face   the face
     * @param weight 3: weights of the face's corners at the place, at least 0
     * @param path   path of the smallest possible node around the place, see {@link NodePath}
     */
    record Place(int face, double[] weight, long path) {

        static Place of(int face, double[] weight) {
            double[] left = weight.clone();
            long path = NodePath.FACE;
            for (int level = 0; level < NodePath.MAX_LEVEL; level++) {
                path = NodePath.child(path, Subdivision.enter(left));
            }
            return new Place(face, weight, path);
        }

        /** 3: weights of the corners of a node around the place. */
        double[] weights(long node) {
            double[] left = weight.clone();
            for (int level = 0; level < NodePath.level(node); level++) {
                Subdivision.enter(left);
            }
            return left;
        }
    }

    /** A point from which a ray has met a place near by, for one of {@link AuditPoint#TIMES}. */
    private record Step(AuditPoint from, int time, Place to) { }

    /** A point at which light is to be gathered for one of {@link AuditPoint#TIMES}. */
    record Near(AuditPoint point, int time) { }

    NearbyPoints(Faces faces, RadiosityBounds bounds, AuditPlaces places) {
        this.faces = faces;
        this.bounds = bounds;
        this.places = places;
        first = new int[faces.scene().triangles()];
        next = new int[faces.count()];
        Arrays.fill(first, -1);
        for (int f = 0; f < next.length; f++) {
            next[f] = first[faces.triangle(f)];
            first[faces.triangle(f)] = f;
        }
    }

    /** Walks from each of some points, once per time. Returns the points at which light is to be gathered for it. */
    List<Near> around(List<AuditPoint> points) {
        List<Near> all = new ArrayList<>();
        List<Step> steps = new ArrayList<>();
        for (AuditPoint point : points) {
            for (int time = 0; time < AuditPoint.TIMES; time++) {
                add(point, time, steps);
            }
        }
        for (int n = 0; n < STEPS && !steps.isEmpty(); n++) {
            List<Near> met = meet(steps);
            steps = new ArrayList<>();
            for (Near near : met) {
                add(near.point, near.time, steps);
            }
            all.addAll(met);
        }
        return all;
    }

    private void add(AuditPoint from, int time, List<Step> steps) {
        Place place = sends(from) ? met(from, time) : null;
        if (place != null) {
            steps.add(new Step(from, time, place));
        }
    }

    /** Whether an error of the light that arrives at a point is sent on from there. */
    private static boolean sends(AuditPoint point) {
        return !point.isBuried && point.reflects();
    }

    private List<Near> meet(List<Step> steps) {
        int[] number = steps.stream().mapToInt(step -> (int) Hash.mix(step.time, step.from.number)).toArray();
        AuditPoint[] point = places.find(steps.stream().map(Step::to).toList(), number);
        List<Near> met = new ArrayList<>();
        for (int i = 0; i < point.length; i++) {
            if (point[i] != null && sends(point[i])) {
                steps.get(i).from.setNear(steps.get(i).time, point[i]);
                met.add(new Near(point[i], steps.get(i).time));
            }
        }
        return met;
    }

    /** The place that a ray meets nearer than the element of a point is large, or null. */
    private Place met(AuditPoint from, int time) {
        float nx = faces.normal(from.face, 0);
        float ny = faces.normal(from.face, 1);
        float nz = faces.normal(from.face, 2);
        long key = Hash.mix(Hash.mix(11 + time, from.face), from.number);
        double[] at = Frame.inCircle(Hash.unit(Hash.mix(key, 0)), Hash.unit(Hash.mix(key, 1)));
        float[] d = Solids.direction(at[0], at[1], faces.unitNormal(from.face));
        float[] x = from.place;
        float[] hit = new float[3];
        int t = bounds.nearestFront(x[0] + LIFT * nx, x[1] + LIFT * ny, x[2] + LIFT * nz, d[0], d[1], d[2],
                (float) Math.sqrt(2 * from.elementArea), true, hit);
        return t < 0 ? null : place(t, d, new Vec3(x[0] + LIFT * nx + hit[0] * (double) d[0],
                x[1] + LIFT * ny + hit[0] * (double) d[1], x[2] + LIFT * nz + hit[0] * (double) d[2]));
    }

    /** The place of a point on that face of a triangle which shows its front to a ray, or null. */
    private Place place(int triangle, float[] d, Vec3 x) {
        Place best = null;
        double most = Double.NEGATIVE_INFINITY;
        for (int f = first[triangle]; f >= 0; f = next[f]) {
            if (faces.normal(f, 0) * d[0] + faces.normal(f, 1) * d[1] + faces.normal(f, 2) * d[2] < 0) {
                double[] weight = weights(f, x);
                double least = Math.min(weight[0], Math.min(weight[1], weight[2]));
                if (least > most) {
                    most = least;
                    best = Place.of(f, inside(weight));
                }
            }
        }
        return best;
    }

    /** 3: weights of a face's corners at a point in its plane; negative where the point lies outside. */
    private double[] weights(int f, Vec3 x) {
        Vec3 a = faces.unitCorner(f, 1).minus(faces.unitCorner(f, 0));
        Vec3 b = faces.unitCorner(f, 2).minus(faces.unitCorner(f, 0));
        Vec3 c = x.minus(faces.unitCorner(f, 0));
        double ab = a.dot(b);
        double whole = a.dot(a) * b.dot(b) - ab * ab;
        double p = (b.dot(b) * a.dot(c) - ab * b.dot(c)) / whole;
        double q = (a.dot(a) * b.dot(c) - ab * a.dot(c)) / whole;
        return new double[] {1 - p - q, p, q};
    }

    /** Weights without what is negative by rounding. */
    private static double[] inside(double[] weight) {
        double p = Math.max(0, weight[0]);
        double q = Math.max(0, weight[1]);
        double r = Math.max(0, weight[2]);
        double sum = p + q + r;
        return new double[] {p / sum, q / sum, r / sum};
    }
}
