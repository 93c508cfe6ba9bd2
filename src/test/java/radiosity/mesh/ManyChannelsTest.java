package radiosity.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.mesh.face.Faces;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.util.TooLargeException;

class ManyChannelsTest {

    /** A million elements, for each of which 256 coloured lamps would have 3 x 768 numbers. */
    @Test
    void lightThatNoArrayHolds_isRefusedBeforeAnyElementIsMade() {
        Vec3 z = new Vec3(0, 0, 1);
        Light lamp = new Light("lamp", Light.Kind.POINT, new Rgb(1, 2, 3), z, z, new Vec3(1, 0, 0), new Vec3(0, 1, 0),
                1, 1, 1);
        Scene scene = new Scene("triangle", new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2},
                new int[] {0},
                List.of(new Surface("s", Rgb.BLACK, new Rgb(.1, .2, .3), false)), Collections.nCopies(256, lamp),
                Optional.empty());
        Faces faces = new Faces(scene, true);
        Patcher patcher = new Patcher(faces, faces.area(0) / (1 << 20), (f, small) -> null);
        List<Block> blocks = Partitioner.blocks(patcher, 64);
        TooLargeException e = assertThrows(TooLargeException.class, () -> new RadiosityNodes(patcher, blocks));
        assertEquals("light shot by elements in 768 channels: expected at most 2,147,483,639 numbers, got 2,415,919,104",
                e.getMessage());
    }
}
