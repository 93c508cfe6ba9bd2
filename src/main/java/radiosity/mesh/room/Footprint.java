package radiosity.mesh.room;

import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.scene.Vec3;

/** Tests whether an open shell, as a block without a bottom, is as good as solid: its whole rim stands on a floor. */
final class Footprint {

    /** A point nearer to a plane or an edge than this lies on it, in scene sizes. */
    private static final double IN_PLANE = 1e-6;

    private final Faces faces;
    private final FaceGroups parts;
    private final int[] own;
    private final List<int[]> rim;

    /**
     * @param parts faces grouped by coplanar region
     * @param own   faces of the open shell; not modified
     * @param rim   the two ends of each edge of the shell's boundary, at least one edge
     */
    Footprint(Faces faces, FaceGroups parts, int[] own, List<int[]> rim) {
        this.faces = faces;
        this.parts = parts;
        this.own = own;
        this.rim = rim;
    }

    /**
     * Whether the rim lies on one coplanar region of a wall, and the shell is seen from outside.
     *
     * @param wall faces of the wall; not modified
     */
    boolean isOn(int[] wall) {
        double[] first = at(rim.get(0)[0]);
        int[] below = IntStream.of(wall).filter(f -> covers(f, first)).map(f -> faces.part[f]).distinct().toArray();
        return below.length > 0 && volumeFrom(first) >= 0 && IntStream.of(below).anyMatch(this::carries);
    }

    private boolean carries(int part) {
        int[] floor = parts.of(part);
        return rim.stream().allMatch(edge -> {
            double[] p = at(edge[0]);
            double[] q = at(edge[1]);
            double[] middle = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
            return lies(floor, p) && lies(floor, q) && lies(floor, middle);
        });
    }

    private boolean lies(int[] floor, double[] p) {
        return IntStream.of(floor).anyMatch(f -> covers(f, p));
    }

    /** Position of a point in the scene brought to size 1 around the origin. */
    private double[] at(int point) {
        Vec3 unit = faces.unit(faces.place(point));
        return new double[] {unit.x(), unit.y(), unit.z()};
    }

    private boolean covers(int f, double[] p) {
        for (int k = 0; k < 3; k++) {
            double[] to = edge(f, k, p);
            double[] along = edge(f, k, corner(f, (k + 1) % 3));
            double inside = 0;
            double length = 0;
            for (int a = 0; a < 3; a++) {
                int b = (a + 1) % 3;
                int c = (a + 2) % 3;
                inside += faces.normal(f, a) * (along[b] * to[c] - along[c] * to[b]);
                length += along[a] * along[a];
            }
            if (inside < -IN_PLANE * Math.sqrt(length)) {
                return false;
            }
        }
        double[] to = edge(f, 0, p);
        double above = faces.normal(f, 0) * to[0] + faces.normal(f, 1) * to[1] + faces.normal(f, 2) * to[2];
        return Math.abs(above) <= IN_PLANE;
    }

    private double[] corner(int f, int k) {
        return new double[] {faces.corner(f, k, 0), faces.corner(f, k, 1), faces.corner(f, k, 2)};
    }

    private double[] edge(int f, int k, double[] to) {
        return new double[] {to[0] - faces.corner(f, k, 0), to[1] - faces.corner(f, k, 1),
                to[2] - faces.corner(f, k, 2)};
    }

    /** Volume of the shell closed by a lid in a plane through an apex, in cubed scene sizes. */
    private double volumeFrom(double[] apex) {
        double sum = 0;
        for (int f : own) {
            double[] a = edge(f, 0, apex);
            sum -= faces.area(f) / 3 * (faces.normal(f, 0) * a[0] + faces.normal(f, 1) * a[1]
                    + faces.normal(f, 2) * a[2]);
        }
        return sum;
    }
}
