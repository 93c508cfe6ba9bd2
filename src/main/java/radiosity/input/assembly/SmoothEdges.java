package radiosity.input.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.util.CommonEdges;
import radiosity.util.PointNumbers;

/**
 * Chooses the smoothing angles of surfaces for a file that says edge by edge which edges look smooth, by normals at the
 * corners of its polygons.
 *
 * <p>The angle of a surface is the one, in whole degrees, by which the least length of the surface's edges is shown
 * otherwise than the file says; among equal angles the least one.
 */
public final class SmoothEdges {

    private static final int DEGREES = 180;
    /** Degrees up to which triangles are one plane facet, whose inner edges say nothing. */
    private static final double PLANE = 0.1;
    /** Distance between unit normals up to which they are equal: half a degree. */
    private static final double EQUAL_NORMALS = 0.01;

    /** Length of the edges of each surface by the angle between their triangles, in degrees rounded up. */
    private final List<double[]> smooth = new ArrayList<>();
    private final List<double[]> sharp = new ArrayList<>();

    /** Whether two unit normals, or two of length 0, are equal but for half a degree. */
    public static boolean areEqual(Vec3 m, Vec3 n) {
        return m.minus(n).length() <= EQUAL_NORMALS;
    }

    /** Says whether two corners of different triangles, at the same point, have the same normal. */
    public interface Corners {
        boolean areAlike(int i, int j);
    }

    /**
     * Adds the edges between the triangles of a mesh.
     *
     * @param points   x, y, z, 3 per point
     * @param corners  points, 3 per triangle
     * @param surfaces index of the surface of each triangle
     * @param normals  compares corners, which are numbered as in {@code corners}
     */
    public void add(float[] points, int[] corners, int[] surfaces, Corners normals) {
        double[] exact = new double[points.length];
        Arrays.setAll(exact, i -> points[i]);
        int[] numbers = PointNumbers.of(exact);
        CommonEdges.visit(Arrays.stream(corners).map(p -> numbers[p]).toArray(), (i, j, k, l) -> {
            if (surfaces[i / 3] == surfaces[j / 3]) {
                double degrees = degrees(cross(exact, corners, i / 3), cross(exact, corners, j / 3));
                if (degrees > PLANE) {
                    boolean isSmooth = normals.areAlike(i, j) && normals.areAlike(k, l);
                    lengths(isSmooth ? smooth : sharp, surfaces[i / 3])[(int) Math.ceil(degrees)] +=
                            point(exact, corners[k]).minus(point(exact, corners[i])).length();
                }
            }
        });
    }

    private static double[] lengths(List<double[]> of, int surface) {
        while (of.size() <= surface) {
            of.add(new double[DEGREES + 1]);
        }
        return of.get(surface);
    }

    private static Vec3 point(double[] points, int p) {
        return new Vec3(points[3 * p], points[3 * p + 1], points[3 * p + 2]);
    }

    /** The angle between two normals of any length; 0 if one of them is zero. */
    private static double degrees(Vec3 m, Vec3 n) {
        double cosine = m.dot(n) / (m.length() * n.length());
        return cosine < 1 ? StrictMath.toDegrees(StrictMath.acos(Math.max(-1, cosine))) : 0;
    }

    private static Vec3 cross(double[] points, int[] corners, int triangle) {
        Vec3 a = point(points, corners[3 * triangle]);
        return point(points, corners[3 * triangle + 1]).minus(a)
                .cross(point(points, corners[3 * triangle + 2]).minus(a));
    }

    /** The surfaces, in the order of their indices, with their smoothing angles. */
    public List<Surface> apply(List<Surface> surfaces) {
        List<Surface> smoothed = new ArrayList<>();
        for (Surface surface : surfaces) {
            smoothed.add(surface.smoothed(StrictMath.toRadians(angle(smoothed.size()))));
        }
        return smoothed;
    }

    /** Degrees. */
    private int angle(int surface) {
        double gain = 0;
        double most = 0;
        int best = 0;
        for (int degrees = 1; degrees <= DEGREES; degrees++) {
            gain += lengths(smooth, surface)[degrees] - lengths(sharp, surface)[degrees];
            if (gain > most) {
                most = gain;
                best = degrees;
            }
        }
        return best;
    }
}
