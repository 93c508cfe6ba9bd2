package radiosity.mesh;

import java.util.function.IntPredicate;
import radiosity.mesh.face.Faces;
import radiosity.visibility.Solids;

/**
 * Finds vertices inside a solid, as where a floor continues below a block: all surfaces in sight show their backs; and
 * vertices that another surface in the same place covers, see {@link CoincidentFaces}.
 *
 * <p>Such a vertex receives no light and would darken the elements around it, so it is marked as buried.
 */
public final class InteriorTest {

    private final Faces faces;
    private final IntPredicate hidden;
    private final Solids solids;
    private final CoincidentFaces coincident;

    /** @param hidden whether a face is known to lie inside a solid */
    public InteriorTest(Faces faces, Solids solids, CoincidentFaces coincident, IntPredicate hidden) {
        this.faces = faces;
        this.hidden = hidden;
        this.solids = solids;
        this.coincident = coincident;
    }

    /** Marks the vertices from {@code first} to {@code last - 1} that no light can reach as buried. */
    public void markBuried(RadiosityNodes nodes, int first, int last) {
        for (int v = first; v < last; v++) {
            if (isBuried(nodes, v)) {
                nodes.points().bury(v);
            }
        }
    }

    private boolean isBuried(RadiosityNodes nodes, int v) {
        ReceivingPoints points = nodes.points();
        return hidden.test(points.face(v)) || isHeld(points.receivers(), 3 * v, points.plane(v));
    }

    /**
     * Whether a point lies inside a solid, or another surface covers it.
     *
     * @param place x, y, z of the point in the scene brought to size 1, 3 from {@code at}; not modified
     * @param f     the face on which the point lies
     */
    public boolean isBuried(float[] place, int at, int f) {
        return hidden.test(f) || isHeld(place, at, f);
    }

    private boolean isHeld(float[] place, int at, int f) {
        return coincident.cover(place, at, f) || solids.hold(place[at], place[at + 1], place[at + 2],
                faces.normal(f, 0), faces.normal(f, 1), faces.normal(f, 2));
    }
}
