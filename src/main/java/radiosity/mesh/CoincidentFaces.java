package radiosity.mesh;

import java.util.BitSet;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.FlatTriangle;
import radiosity.util.DisjointSets;
import radiosity.visibility.RadiosityBounds;

/**
 * Tells which points of surfaces are covered by another surface in the same place, such as a wall behind a poster that
 * was modelled in the wall's plane, or the back of a shelf's board in that of its panel.
 *
 * <p>Both would receive, reflect and shoot the light that arrives there once, and a point that sees the place would see
 * it twice: rays end a little above surfaces, so neither hides the other. One of the surfaces counts, therefore: the
 * one above, or where both lie at the same height the one that emits light; else the smaller one, as a label is meant
 * to be seen and not what is behind the label; else the first.
 */
public final class CoincidentFaces {

    private static final float HEIGHT = (float) Faces.COVERING;
    /** Height up to which two surfaces lie at the same height, in units of the scene's size. */
    private static final float SAME = 1e-6f;
    /** Weight of the other two corners at a point near a corner. */
    private static final float NEAR = 0.05f;
    /** Least cosine between the normals of two surfaces in one place. */
    private static final float PARALLEL = 0.999f;

    private final Faces faces;
    private final RadiosityBounds bounds;
    /** 3 per original triangle: normal of its visible side, 0 where both sides are visible. */
    private final float[] fronts;
    /** 1 per original triangle: a face of that triangle, -1 where the triangle is too small to have one. */
    private final int[] faceOf;
    /** 1 per original triangle: the lowest of the triangles that are connected to it in one plane. */
    private final int[] region;
    /** Area of each region, at its lowest triangle, in squared scene sizes. */
    private final double[] area;
    /** The faces in whose place another surface may lie that counts there: few in most scenes. */
    private final BitSet contested = new BitSet();

    /** @param bounds the original triangles */
    public CoincidentFaces(Faces faces, RadiosityBounds bounds) {
        this.faces = faces;
        this.bounds = bounds;
        fronts = faces.fronts();
        int triangles = fronts.length / 3;
        faceOf = IntStream.generate(() -> -1).limit(triangles).toArray();
        DisjointSets regions = new DisjointSets(triangles);
        for (int f = 0; f < faces.count(); f++) {
            faceOf[faces.triangle(f)] = f;
            regions.join(faces.triangle(f), faces.triangle(faces.part[f]));
        }
        region = IntStream.range(0, triangles).map(regions::of).toArray();
        area = new double[triangles];
        for (int f = 0; f < faces.count(); f++) {
            area[region[faces.triangle(f)]] += faces.area(f);
        }
        for (int f = 0; f < faces.count(); f++) {
            contested.set(f, isContested(f));
        }
    }

    /** Whether an original triangle near a face may count in a place of the face: if it comes first, or rises above. */
    private boolean isContested(int f) {
        float[] corners = new float[9];
        float[] low = new float[3];
        float[] high = new float[3];
        for (int i = 0; i < 9; i++) {
            corners[i] = faces.corner(f, i / 3, i % 3);
            low[i % 3] = (i < 3 ? corners[i] : Math.min(low[i % 3], corners[i])) - HEIGHT;
            high[i % 3] = (i < 3 ? corners[i] : Math.max(high[i % 3], corners[i])) + HEIGHT;
        }
        FlatTriangle face = new FlatTriangle(corners);
        int own = faces.triangle(f);
        return bounds.touches(low, high, (t, all, at) -> isBeside(t, f) && !face.hasBeyondAnEdge(all, at)
                && (comesFirst(t, own) || rises(t, f))
                && !new FlatTriangle(bounds.corners(t)).hasBeyondAnEdge(corners, 0));
    }

    /** Whether an original triangle has a corner above a face's plane, or not clearly at the height of the plane. */
    private boolean rises(int t, int f) {
        float[] corners = bounds.corners(t);
        double highest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double height = 0;
            for (int a = 0; a < 3; a++) {
                height += faces.normal(f, a) * ((double) corners[3 * k + a] - faces.corner(f, 0, a));
            }
            highest = Math.max(highest, height);
        }
        return highest > SAME / 2;
    }

    /**
     * Whether another surface lies in the place of a face, and counts there.
     *
     * @param place x, y, z of a point of the face, in the scene brought to size 1, 3 from {@code at}; not modified
     */
    boolean cover(float[] place, int at, int f) {
        if (!contested.get(f)) {
            return false;
        }
        float nx = faces.normal(f, 0);
        float ny = faces.normal(f, 1);
        float nz = faces.normal(f, 2);
        return bounds.meets(place[at] + HEIGHT * nx, place[at + 1] + HEIGHT * ny, place[at + 2] + HEIGHT * nz,
                -nx, -ny, -nz, 0, HEIGHT + SAME, t -> isBeside(t, f),
                (t, distance) -> HEIGHT - distance > SAME || comesFirst(t, faces.triangle(f)));
    }

    /** The faces that other surfaces cover at their middle and near each corner. */
    public BitSet covered() {
        BitSet covered = new BitSet();
        for (int f = 0; f < faces.count(); f++) {
            boolean isCovered = cover(faces.middle(f), 0, f);
            for (int k = 0; k < 3 && isCovered; k++) {
                isCovered = cover(beside(f, k), 0, f);
            }
            covered.set(f, isCovered);
        }
        return covered;
    }

    /** A point of a face near one of its corners. */
    private float[] beside(int f, int corner) {
        float[] place = new float[3];
        for (int i = 0; i < 9; i++) {
            place[i % 3] += (i / 3 == corner ? 1 - 2 * NEAR : NEAR) * faces.corner(f, i / 3, i % 3);
        }
        return place;
    }

    /** Whether an original triangle looks the same way as a face, and is of another region. */
    private boolean isBeside(int t, int f) {
        return faceOf[t] >= 0 && region[t] != region[faces.triangle(f)] && looksAlong(t, f);
    }

    /** Whether an original triangle's visible side faces as a face does. */
    private boolean looksAlong(int t, int f) {
        boolean isTwoSided = fronts[3 * t] == 0 && fronts[3 * t + 1] == 0 && fronts[3 * t + 2] == 0;
        float cosine = 0;
        for (int a = 0; a < 3; a++) {
            cosine += faces.normal(faceOf[t], a) * faces.normal(f, a);
        }
        return (isTwoSided ? Math.abs(cosine) : cosine) >= PARALLEL;
    }

    private boolean comesFirst(int t, int own) {
        boolean emits = faces.emits(faceOf[t]);
        if (emits != faces.emits(faceOf[own])) {
            return emits;
        }
        double here = area[region[own]];
        double there = area[region[t]];
        return there < here || there == here && t < own;
    }
}
