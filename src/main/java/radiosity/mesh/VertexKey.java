package radiosity.mesh;

import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.util.EdgeKey;
import radiosity.util.Hash;

/** Keys of vertices by place: a corner of faces, a place on an edge that faces may share, or one inside a face. */
final class VertexKey {

    private VertexKey() { }

    /** @param w weights of the face's corners, 3 from {@code at}, in units of 2^-30; not modified */
    static long of(Faces faces, int f, int[] w, int at) {
        for (int k = 0; k < 3; k++) {
            if (w[at + k] == NodePath.ONE) {
                return Hash.mix(1, faces.fan[3 * f + k]);
            }
        }
        for (int k = 0; k < 3; k++) {
            if (w[at + k] == 0) {
                int p = faces.point[3 * f + (k + 1) % 3];
                int q = faces.point[3 * f + (k + 2) % 3];
                int toQ = w[at + (k + 2) % 3];
                long of = faces.isBorder(f, k) ? ~f : faces.part[f];
                long ends = EdgeKey.of(p, q);
                return Hash.mix(Hash.mix(Hash.mix(2, of), ends), p < q ? toQ : NodePath.ONE - toQ);
            }
        }
        return Hash.mix(Hash.mix(Hash.mix(3, f), w[at]), w[at + 1]);
    }

    /**
     * The representative face of a vertex, equal for all faces that share it: the lowest face around a corner, the
     * lowest around the ends of an edge inside a region, else the face.
     *
     * @param w weights of the face's corners, 3 from {@code at}, in units of 2^-30; not modified
     */
    static int face(Faces faces, int f, int[] w, int at) {
        for (int k = 0; k < 3; k++) {
            int p = faces.fan[3 * f + (k + 1) % 3] / 3;
            int q = faces.fan[3 * f + (k + 2) % 3] / 3;
            if (w[at + k] == NodePath.ONE) {
                return faces.fan[3 * f + k] / 3;
            }
            if (w[at + k] == 0 && w[at + (k + 1) % 3] != 0 && w[at + (k + 2) % 3] != 0
                    && !faces.isBorder(f, k)) {
                return Math.min(p, q);
            }
        }
        return f;
    }
}
