package radiosity.mesh.face;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;
import radiosity.util.LongIndex;

class FacePiecesTest {

    @Test
    void faceAfterAPieceWithoutArea_isNoPiece() {
        Scene scene = new SceneBuilder()
                .polygon(RoomScenes.grey("cut", 0, 0.5), new Vec3(0, 0, 0), new Vec3(1, 0, 0), new Vec3(0, 1, 0))
                .polygon(RoomScenes.grey("whole", 0, 0.5), new Vec3(0, 0, 1), new Vec3(1, 0, 1), new Vec3(0, 1, 1))
                .scene("triangles");
        Faces faces = new Faces(scene);
        int[] corners = {faces.point[0], faces.point[1], faces.point[2]};
        int[] none = {corners[0], corners[1], corners[1]};
        Faces cut = faces.withPieces(new FacePieces(new CutPoints(scene, 1e-7), Map.of(0, List.of(corners, none)),
                new LongIndex(0)));
        assertEquals(2, cut.count());
        assertTrue(cut.isPiece(0));
        assertFalse(cut.isPiece(1));
    }
}
