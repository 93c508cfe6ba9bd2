package radiosity.mesh.face;

import java.util.Arrays;
import radiosity.util.DisjointSets;
import radiosity.util.EdgeKey;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/**
 * Finds the faces of a surface that meet along an edge in one plane. Fills the arrays {@code part}, {@code fan} and
 * {@code across} of the faces.
 */
final class CoplanarRegions {

    /** Largest angle between the normals of neighbouring faces of one region, radians. */
    private static final double SAME_PLANE = 1e-4;

    private final Faces faces;

    CoplanarRegions(Faces faces) {
        this.faces = faces;
    }

    /**
     * Joins faces to regions. An edge is inside a region where exactly two faces share it, else it is a border.
     *
     * @param cut edges that are borders in any case, see {@link EdgeKey}; not modified
     */
    void join(LongIndex cut) {
        int n = faces.count();
        DisjointSets parts = new DisjointSets(faces.part.length);
        DisjointSets fans = new DisjointSets(faces.fan.length);
        Arrays.fill(faces.across, -1);
        int[] next = new int[3 * n];
        LongIndex edges = new LongIndex(3L * n);
        int[] first = new int[3 * n];
        Arrays.fill(first, -1);
        for (int e = 0; e < 3 * n; e++) {
            int number = edges.findOrAdd(key(e), edges.size());
            next[e] = first[number];
            first[number] = e;
        }
        for (int i = 0; i < edges.size(); i++) {
            int e = first[i];
            int g = next[e];
            if (g >= 0 && next[g] < 0 && matches(e, g) && cut.find(EdgeKey.of(corner(e, 1), corner(e, 2))) < 0) {
                faces.across[e] = g / 3;
                faces.across[g] = e / 3;
                parts.join(e / 3, g / 3);
                fans.join(slot(e, 1), slot(g, 2));
                fans.join(slot(e, 2), slot(g, 1));
            }
        }
        Arrays.setAll(faces.part, parts::of);
        Arrays.setAll(faces.fan, fans::of);
    }

    /** Key of edge e, which lies opposite corner e % 3 of face e / 3; equal for faces of one surface and side. */
    private long key(int e) {
        int f = e / 3;
        int surface = faces.scene().surfaceOf()[faces.triangle(f)];
        return Hash.mix(EdgeKey.of(corner(e, 1), corner(e, 2)), 2L * surface + (faces.side(f) & 1));
    }

    /** Whether two edges run in opposite directions between the same points, and their faces lie in one plane. */
    private boolean matches(int e, int g) {
        int f = e / 3;
        int h = g / 3;
        if (corner(e, 1) != corner(g, 2) || corner(e, 2) != corner(g, 1)) {
            return false;
        }
        double apart = 0;
        for (int a = 0; a < 3; a++) {
            double d = (double) faces.normal(f, a) - faces.normal(h, a);
            apart += d * d;
        }
        return apart < SAME_PLANE * SAME_PLANE;
    }

    private int corner(int e, int step) {
        return faces.point[slot(e, step)];
    }

    private static int slot(int e, int step) {
        return 3 * (e / 3) + (e % 3 + step) % 3;
    }
}
