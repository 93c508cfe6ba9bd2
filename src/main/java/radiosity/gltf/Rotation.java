package radiosity.gltf;

import radiosity.scene.Affine;

/** Rotations as glTF's unit quaternions x, y, z, w. */
public final class Rotation {

    private Rotation() { }

    /**
     * The quaternion of a rotation matrix, from its largest component: K. Shoemake, Quaternions, 1994.
     *
     * @param map a rotation, whose offset has no effect
     */
    public static double[] quaternion(Affine map) {
        double[][] m = {map.direction(1, 0, 0), map.direction(0, 1, 0), map.direction(0, 0, 1)};
        double trace = m[0][0] + m[1][1] + m[2][2];
        double[] q = new double[4];
        int largest = 3;
        for (int i = 0; i < 3; i++) {
            if (m[i][i] > (largest == 3 ? trace : m[largest][largest])) {
                largest = i;
            }
        }
        if (largest == 3) {
            q[3] = 1 + trace;
            q[0] = m[1][2] - m[2][1];
            q[1] = m[2][0] - m[0][2];
            q[2] = m[0][1] - m[1][0];
        } else {
            int j = (largest + 1) % 3;
            int k = (largest + 2) % 3;
            q[largest] = 1 + m[largest][largest] - m[j][j] - m[k][k];
            q[j] = m[largest][j] + m[j][largest];
            q[k] = m[largest][k] + m[k][largest];
            q[3] = m[j][k] - m[k][j];
        }
        return unit(q);
    }

    /** The quaternion of the rotation that applies q first and then p; both are not modified. */
    public static double[] product(double[] p, double[] q) {
        return unit(new double[] {
            p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1],
            p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
            p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3],
            p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]});
    }

    /** A quaternion of length 1 from one of any length but 0, which is not modified. */
    static double[] unit(double[] q) {
        double length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        return new double[] {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
    }
}
