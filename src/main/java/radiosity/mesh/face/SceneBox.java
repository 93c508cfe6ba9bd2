package radiosity.mesh.face;

import java.util.Arrays;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/**
 * How a scene is brought to size 1 around the origin.
 *
 * @param centre middle of the box of all triangles, scene units
 * @param size   its largest extent, scene units; 1 where it has none
 */
record SceneBox(Vec3 centre, double size) {

    static SceneBox of(Scene scene) {
        double[] box = scene.triangles() == 0 ? new double[6] : corners(scene);
        double extent = Math.max(box[3] - box[0], Math.max(box[4] - box[1], box[5] - box[2]));
        return new SceneBox(new Vec3((box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2),
                extent > 0 ? extent : 1);
    }

    private static double[] corners(Scene scene) {
        double[] box = new double[6];
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
        for (int p : scene.corners()) {
            for (int a = 0; a < 3; a++) {
                double x = scene.points()[3 * p + a];
                box[a] = Math.min(box[a], x);
                box[3 + a] = Math.max(box[3 + a], x);
            }
        }
        return box;
    }

    Vec3 unit(Vec3 p) {
        return p.minus(centre).times(1 / size);
    }
}
