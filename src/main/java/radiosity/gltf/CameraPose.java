package radiosity.gltf;

import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Vec3;

/**
 * Converts a camera's rotation from and to glTF's: a unit quaternion x, y, z, w that turns -z to forward and +y to up.
 */
public final class CameraPose {

    private CameraPose() {
    }

    /** The quaternion of a camera's rotation. */
    public static double[] quaternion(Camera camera) {
        Vec3 z = camera.forward().times(-1).unit();
        Vec3 x = camera.up().cross(z).unit();
        Vec3 y = z.cross(x);
        return Rotation.quaternion(new Affine(new double[] {x.x(), y.x(), z.x(), 0, x.y(), y.y(), z.y(), 0, x.z(),
            y.z(), z.z(), 0}));
    }
    /**
     * The camera at a position with a rotation.
     *
     * @param rotation x, y, z, w of any length but 0; not modified
     * @param yfov     whole vertical angle of view, radians
     * @param aspect   width over height
     */
    public static Camera camera(Vec3 position, double[] rotation, double yfov, double aspect) {
        double[] q = Rotation.unit(rotation);
        Vec3 v = new Vec3(q[0], q[1], q[2]);
        return new Camera(position, turn(v, q[3], new Vec3(0, 0, -1)), turn(v, q[3], new Vec3(0, 1, 0)), yfov / 2,
                aspect);
    }

    private static Vec3 turn(Vec3 v, double w, Vec3 p) {
        Vec3 t = v.cross(p).times(2);
        return p.plus(t.times(w)).plus(v.cross(t));
    }
}
