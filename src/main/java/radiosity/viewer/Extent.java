package radiosity.viewer;

import java.util.stream.IntStream;
import radiosity.output.gltf.LitScene;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/**
 * How large a scene is and where.
 *
 * @param centre of its box
 * @param size   diagonal of its box, scene units, above 0
 */
record Extent(Vec3 centre, double size) {

    static Extent of(LitScene scene) {
        Aabb box = Aabb.of(scene.meshes().stream().flatMap(mesh -> IntStream.range(0, mesh.corners().length)
                .mapToObj(i -> mesh.position(i / 3, i % 3))));
        return new Extent(box.centre().plus(scene.origin()), box.diagonal() > 0 ? box.diagonal() : 1);
    }
}
