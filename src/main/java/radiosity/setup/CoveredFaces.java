package radiosity.setup;

import radiosity.mesh.CoincidentFaces;
import radiosity.mesh.InteriorTest;
import radiosity.mesh.Patcher;
import radiosity.mesh.cut.DiscontinuityMesher;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.face.Subdivision;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;

/**
 * Estimates which share of each small face lies outside of solids and is not covered by another face in the same place.
 * A large face is cut into pieces where solids stand on it or pass through it; a small one is not, but light neither
 * arrives on its covered part nor leaves it.
 */
final class CoveredFaces implements Patcher.PointRule {

    /** Levels of subdivision at which the middles of a partly covered face are tested. */
    private static final int LEVELS = 3;
    /** Share of a face that is covered everywhere: no area is 0. */
    private static final double LEAST = 1e-6;
    /** Size of the triangle at a corner that stands for the corner, relative to the face. */
    private static final float NEAR = 0.05f;
    /** Height above a face at which a ray along the face looks for what stands on it, relative to the scene size. */
    private static final float LIFT = (float) RadiosityBounds.LIFT;

    private final Faces faces;
    private final RadiosityBounds bounds;
    private final InteriorTest interior;

    CoveredFaces(Faces faces, RadiosityBounds bounds, Solids solids, CoincidentFaces coincident) {
        this.faces = faces;
        this.bounds = bounds;
        interior = new InteriorTest(faces, solids, coincident, f -> false);
    }

    /** The share of a face that lies outside of solids, above 0 and at most 1; NaN for large faces and for pieces. */
    double visibleShare(int face) {
        return isWhole(face) ? Double.NaN : Math.max(LEAST, visibleShare(face, corners(face), 1));
    }

    /** Whether a face is large enough to be cut, or a piece of such a face. */
    private boolean isWhole(int face) {
        return faces.isPiece(face) || faces.area(face) > DiscontinuityMesher.LEAST_AREA * faces.area();
    }

    private float[] corners(int face) {
        return faces.corners(face, NodePath.FACE);
    }

    /**
     * Where an undivided face receives: at its middle where it is small, or where all its corners are covered, as those
     * of a canvas in its frame. Where the middle is covered, too, at the middle of a part of the face that is not.
     *
     * @return x, y, z in the scene brought to size 1; null where the face receives at its corners
     */
    @Override
    public float[] point(int face, boolean isSmall) {
        if (!isSmall && (isWhole(face) || !isCoveredAtCorners(face))) {
            return null;
        }
        float[] visible = visiblePart(face, corners(face), 0);
        return visible == null ? faces.middle(face) : middle(visible);
    }

    private boolean isCoveredAtCorners(int face) {
        boolean all = true;
        for (int k = 0; k < 3 && all; k++) {
            all = isCovered(face, near(corners(face), k));
        }
        return all;
    }

    /** The triangle where its middle is not covered, else the first such part of it; null where there is none. */
    private float[] visiblePart(int face, float[] corners, int level) {
        if (!isCovered(face, corners)) {
            return corners;
        }
        float[] found = null;
        for (int k = 3; k >= 0 && found == null && level < LEVELS; k--) {
            float[] child = new float[9];
            Subdivision.child(corners, 0, k, child, 0);
            found = visiblePart(face, child, level + 1);
        }
        return found;
    }

    /**
     * Whether another surface stands on a small face or passes through it, so that there may be two kinds of light on
     * the face: whether the middle does not see the corners.
     */
    @Override
    public boolean divides(int face) {
        boolean isCrossed = false;
        float[] from = lifted(face, faces.middle(face));
        for (int k = 0; k < 3 && !isCrossed && !isWhole(face); k++) {
            float[] to = lifted(face, middle(near(corners(face), k)));
            isCrossed = bounds.blocked(from[0], from[1], from[2], to[0], to[1], to[2]);
        }
        return isCrossed;
    }

    private float[] lifted(int face, float[] place) {
        float[] at = new float[3];
        for (int a = 0; a < 3; a++) {
            at[a] = place[a] + LIFT * faces.normal(face, a);
        }
        return at;
    }

    /** A small triangle at a corner of a triangle. */
    private static float[] near(float[] corners, int k) {
        float[] near = new float[9];
        for (int i = 0; i < 9; i++) {
            near[i] = (1 - NEAR) * corners[3 * k + i % 3] + NEAR * corners[i];
        }
        return near;
    }

    /** Divides a triangle in four, and each of these again unless all four middles are alike. */
    private double visibleShare(int face, float[] corners, int level) {
        float[][] child = new float[4][9];
        int visible = 0;
        for (int k = 0; k < 4; k++) {
            Subdivision.child(corners, 0, k, child[k], 0);
            visible += isCovered(face, child[k]) ? 0 : 1;
        }
        if (visible == 0 || visible == 4 || level == LEVELS) {
            return visible / 4.0;
        }
        double sum = 0;
        for (float[] part : child) {
            sum += visibleShare(face, part, level + 1) / 4;
        }
        return sum;
    }

    private static float[] middle(float[] corners) {
        float[] middle = new float[3];
        for (int a = 0; a < 3; a++) {
            middle[a] = (corners[a] + corners[3 + a] + corners[6 + a]) / 3;
        }
        return middle;
    }

    /** Whether the middle of a part of a face lies inside a solid, or another surface covers the middle. */
    private boolean isCovered(int face, float[] corners) {
        return interior.isBuried(middle(corners), 0, face);
    }
}
