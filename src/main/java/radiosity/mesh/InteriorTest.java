package radiosity.mesh;

import java.util.function.IntPredicate;
import radiosity.mesh.face.Faces;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;

/**
 * Which vertices lie inside a solid, where a floor runs on below a block: whatever they look at turns its back.
 *
 * <p>Such a vertex stays black and would darken the elements around it.
 */
public final class InteriorTest {

    private final Faces faces;
    private final IntPredicate hidden;
    private final Solids solids;

    /** @param hidden which faces are known to lie inside one */
    public InteriorTest(Faces faces, RadiosityBounds bounds, IntPredicate hidden) {
        this.faces = faces;
        this.hidden = hidden;
        solids = new Solids(bounds, faces.fronts());
    }

    /** Marks those of the vertices from first on that are buried. */
    public void look(RadiosityNodes nodes, int first, int last) {
        for (int v = first; v < last; v++) {
            if (isBuried(nodes, v)) {
                nodes.bury(v);
            }
        }
    }

    private boolean isBuried(RadiosityNodes nodes, int v) {
        return hidden.test(nodes.vertexFace(v)) || isHeld(nodes.receivers(), 3 * v, nodes.vertexPlane(v));
    }

    /**
     * Whether a point lies inside a solid.
     *
     * @param place x, y, z of the scene brought to size 1, 3 from {@code at}
     * @param f     the face on which it lies
     */
    public boolean isBuried(float[] place, int at, int f) {
        return hidden.test(f) || isHeld(place, at, f);
    }

    private boolean isHeld(float[] place, int at, int f) {
        return solids.hold(place[at], place[at + 1], place[at + 2],
                faces.normal(f, 0), faces.normal(f, 1), faces.normal(f, 2));
    }
}
