package radiosity.mesh.room;

import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.scene.Vec3;

/** Tests whether an open shell, as a block without a bottom, is as good as solid: its whole rim stands on a floor. */
final class Footprint {

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
        Vec3 first = at(rim.get(0)[0]);
        int[] below = IntStream.of(wall).filter(f -> covers(f, first)).map(f -> faces.part[f]).distinct().toArray();
        return below.length > 0 && volumeFrom(first) >= 0 && IntStream.of(below).anyMatch(this::carries);
    }

    private boolean carries(int part) {
        int[] floor = parts.of(part);
        return rim.stream().allMatch(edge -> {
            Vec3 p = at(edge[0]);
            Vec3 q = at(edge[1]);
            return lies(floor, p) && lies(floor, q) && lies(floor, p.plus(q).times(0.5));
        });
    }

    private boolean lies(int[] floor, Vec3 p) {
        return IntStream.of(floor).anyMatch(f -> covers(f, p));
    }

    /** Position of a point in the scene brought to size 1 around the origin. */
    private Vec3 at(int point) {
        return faces.unit(faces.place(point));
    }

    private boolean covers(int f, Vec3 p) {
        for (int k = 0; k < 3; k++) {
            Vec3 from = faces.unitCorner(f, k);
            Vec3 along = faces.unitCorner(f, (k + 1) % 3).minus(from);
            if (faces.unitNormal(f).dot(along.cross(p.minus(from))) < -Faces.NEAR * along.length()) {
                return false;
            }
        }
        return Math.abs(faces.unitNormal(f).dot(p.minus(faces.unitCorner(f, 0)))) <= Faces.NEAR;
    }

    /** Volume of the shell closed by a lid in a plane through an apex, in cubed scene sizes. */
    private double volumeFrom(Vec3 apex) {
        double sum = 0;
        for (int f : own) {
            sum -= faces.area(f) / 3 * faces.unitNormal(f).dot(apex.minus(faces.unitCorner(f, 0)));
        }
        return sum;
    }
}
