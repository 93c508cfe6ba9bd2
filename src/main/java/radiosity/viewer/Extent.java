package radiosity.viewer;

import radiosity.output.gltf.LitScene;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Vec3;

/**
 * How large a scene is and where.
 *
 * @param centre of its box
 * @param size   diagonal of its box, scene units, above 0
 */
record Extent(Vec3 centre, double size) {

    static Extent of(LitScene scene) {
        double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
        double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        boolean empty = true;
        for (Mesh mesh : scene.meshes()) {
            float[] x = mesh.positions();
            for (int i = 0; i < x.length; i++) {
                low[i % 3] = Math.min(low[i % 3], x[i]);
                high[i % 3] = Math.max(high[i % 3], x[i]);
                empty = false;
            }
        }
        if (empty) {
            return new Extent(scene.origin(), 1);
        }
        Vec3 a = new Vec3(low[0], low[1], low[2]);
        Vec3 b = new Vec3(high[0], high[1], high[2]);
        double size = b.minus(a).length();
        return new Extent(a.plus(b).times(0.5).plus(scene.origin()), size > 0 ? size : 1);
    }
}
