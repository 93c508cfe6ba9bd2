package radiosity.viewer;

import java.util.stream.IntStream;
import radiosity.output.gltf.LitScene;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/**
 * Size and position of a scene.
 *
 * @param centre centre of the scene's box, scene units
 * @param size   diagonal of the scene's box, scene units, above 0
 */
record Extent(Vec3 centre, double size) {

    static Extent of(LitScene scene) {
        Aabb box = Aabb.of(scene.meshes().stream().flatMap(mesh -> IntStream.range(0, mesh.corners().length)
                .mapToObj(i -> mesh.position(i / 3, i % 3))));
        return new Extent(box.centre().plus(scene.origin()), box.diagonal() > 0 ? box.diagonal() : 1);
    }
}
