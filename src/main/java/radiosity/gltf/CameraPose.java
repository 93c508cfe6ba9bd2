package radiosity.gltf;

import radiosity.scene.Camera;
import radiosity.scene.Vec3;

/**
 * Converts a camera's rotation from and to glTF's: a unit quaternion x, y, z, w that turns -z to forward and +y to up.
 */
public final class CameraPose {

    private CameraPose() {
    }

    /** The quaternion of a camera's rotation matrix, from its largest component: K. Shoemake, Quaternions, 1994. */
    public static double[] quaternion(Camera camera) {
        Vec3 z = camera.forward().times(-1).unit();
        Vec3 x = camera.up().cross(z).unit();
        Vec3 y = z.cross(x);
        double[][] m = {{x.x(), y.x(), z.x()}, {x.y(), y.y(), z.y()}, {x.z(), y.z(), z.z()}};
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
            q[0] = m[2][1] - m[1][2];
            q[1] = m[0][2] - m[2][0];
            q[2] = m[1][0] - m[0][1];
        } else {
            int j = (largest + 1) % 3;
            int k = (largest + 2) % 3;
            q[largest] = 1 + m[largest][largest] - m[j][j] - m[k][k];
            q[j] = m[j][largest] + m[largest][j];
            q[k] = m[k][largest] + m[largest][k];
            q[3] = m[k][j] - m[j][k];
        }
        return unit(q);
    }

    private static double[] unit(double[] q) {
        double length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        return new double[] {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
    }

    /**
     * The camera at a position with a rotation.
     *
     * @param rotation x, y, z, w of any length but 0; not modified
     * @param yfov     whole vertical angle of view, radians
     * @param aspect   width over height
     */
    public static Camera camera(Vec3 position, double[] rotation, double yfov, double aspect) {
        double[] q = unit(rotation);
        Vec3 v = new Vec3(q[0], q[1], q[2]);
        return new Camera(position, turn(v, q[3], new Vec3(0, 0, -1)), turn(v, q[3], new Vec3(0, 1, 0)), yfov / 2,
                aspect);
    }

    private static Vec3 turn(Vec3 v, double w, Vec3 p) {
        Vec3 t = v.cross(p).times(2);
        return p.plus(t.times(w)).plus(v.cross(t));
    }
}
