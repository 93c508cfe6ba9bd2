package radiosity.mesh.face;

import java.util.Arrays;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/**
 * The transformation that brings a scene to size 1 around the origin.
 *
 * @param centre centre of the box around all triangles, scene units
 * @param size   largest extent of the box, scene units; 1 where it has none
 */
public record SceneBox(Vec3 centre, double size) {

    public static SceneBox of(Scene scene) {
        Aabb box = Aabb.of(Arrays.stream(scene.corners()).mapToObj(scene::point));
        Vec3 extent = box.extent();
        double size = Math.max(extent.x(), Math.max(extent.y(), extent.z()));
        return new SceneBox(box.centre(), size > 0 ? size : 1);
    }

    Vec3 unit(Vec3 p) {
        return p.minus(centre).times(1 / size);
    }
}
