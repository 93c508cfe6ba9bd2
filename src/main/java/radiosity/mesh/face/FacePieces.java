package radiosity.mesh.face;

import java.util.List;
import java.util.Map;
import radiosity.util.EdgeKey;
import radiosity.util.LongIndex;

/**
 * The pieces into which faces are cut.
 *
 * @param points the corners of the pieces
 * @param byFace for each face that is cut, the three points of each of its pieces
 * @param edges  edges of pieces that stay borders of coplanar regions, see {@link EdgeKey}
 */
public record FacePieces(CutPoints points, Map<Integer, List<int[]>> byFace, LongIndex edges) {

    /** Number of pieces of all faces that are cut. */
    int count() {
        return byFace.values().stream().mapToInt(List::size).sum();
    }
}
