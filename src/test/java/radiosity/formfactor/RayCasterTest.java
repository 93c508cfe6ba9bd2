package radiosity.formfactor;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import radiosity.mesh.PatchTree;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.scene.Rgb;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.visibility.RadiosityBounds;

/** Without a limit on the light of a ray there is no measure for the rays at clusters, nor for the rays to be spared. */
class RayCasterTest {

    private static final Surface LAMP = new Surface("lamp", Rgb.grey(1), Rgb.BLACK, false);
    private static final Faces FACES = new Faces(new SceneBuilder().polygon(LAMP, new Vec3(0, 0, 1),
            new Vec3(0, 1, 1), new Vec3(1, 1, 1), new Vec3(1, 0, 1)).scene("lamp"));
    private static final RadiosityBounds BOUNDS = new RadiosityBounds(FACES.occluders());

    @Test
    void clusterWithoutALimitOnRays_isRefused() {
        List<PatchTree> both = IntStream.range(0, FACES.count())
                .mapToObj(f -> new PatchTree(f, NodePath.FACE, new int[] {-1}, new double[] {1, 1, 1})).toList();
        ShooterHierarchy cluster = new ShooterHierarchy(FACES, both, Weights.of(new double[] {1}));
        RayCaster caster = new RayCaster(BOUNDS, 1, Double.POSITIVE_INFINITY);
        GatherSink.Irradiance sum = new GatherSink.Irradiance(1);
        assertThrows(IllegalArgumentException.class, () -> caster.gather(0, 0, -9, 0, 0, 1, 7, cluster, sum));
    }

    @Test
    void sparingWithoutALimitOnRays_isRefused() {
        assertThrows(IllegalArgumentException.class, () -> RayCaster.sparing(BOUNDS, 1, Double.POSITIVE_INFINITY));
    }
}
