package radiosity.mesh.room;

import java.util.BitSet;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.util.BoxTree;

/**
 * Finds the triangles that lie inside a closed solid, such as what a cupboard holds that is modelled as one box. No
 * light enters a solid, so where neither a source nor the camera is inside, light reaches none of these triangles.
 * Rays from a surface in contact with the solid, as the upper side of a lamp below the cupboard, would meet them.
 */
public final class EnclosedTriangles {

    /** What reaches out of the box around a solid by less than this is in the box, in scene sizes. */
    private static final double TOUCH = 1e-6;
    /** Most pairs of a face and a face of a solid that are tested; a solid with more pairs encloses nothing. */
    private static final long MOST_PAIRS = 5_000_000;

    private final Faces faces;
    private final FaceShells shells;
    private final FaceGroups members;
    private final LightPlaces lights;
    /** 1 per triangle: number of its faces. */
    private final int[] sides;
    /** 1 per face: whether the face lies inside a solid. */
    private final BitSet inside = new BitSet();

    private EnclosedTriangles(Faces faces) {
        this.faces = faces;
        shells = new FaceShells(faces);
        members = new FaceGroups(shells.shell);
        lights = new LightPlaces(faces);
        sides = new int[faces.scene().triangles()];
        for (int f = 0; f < faces.count(); f++) {
            sides[faces.triangle(f)]++;
        }
        int[] all = IntStream.range(0, faces.count()).filter(f -> shells.shell[f] == f).toArray();
        BoxTree tree = new BoxTree(IntStream.of(all).boxed()
                .flatMapToDouble(s -> IntStream.range(0, 6).mapToDouble(i -> shells.box[6 * s + i])).toArray());
        for (int s : all) {
            if (shells.isWhole(s) && shells.volume[s] > 0) {
                int[] contents = contents(s, all, tree);
                if (contents.length > 0) {
                    enclose(members.of(s), s, contents);
                }
            }
        }
    }

    /** The triangles that lie inside a solid, by number in the faces' scene. */
    public static BitSet of(Faces faces) {
        EnclosedTriangles all = new EnclosedTriangles(faces);
        int[] free = all.sides.clone();
        all.inside.stream().forEach(f -> free[faces.triangle(f)]--);
        BitSet enclosed = new BitSet();
        IntStream.range(0, free.length).filter(t -> all.sides[t] > 0 && free[t] == 0).forEach(enclosed::set);
        return enclosed;
    }

    /** The other shells whose boxes lie in the box of a shell. */
    private int[] contents(int of, int[] all, BoxTree tree) {
        double[] box = shells.box;
        IntStream.Builder found = IntStream.builder();
        tree.any(BoxTree.overlapping(box, 6 * of, 0), i -> {
            boolean isWithin = all[i] != of;
            for (int a = 0; a < 3 && isWithin; a++) {
                isWithin = box[6 * all[i] + a] > box[6 * of + a] - TOUCH
                        && box[6 * all[i] + 3 + a] < box[6 * of + 3 + a] + TOUCH;
            }
            if (isWithin) {
                found.add(all[i]);
            }
            return false;
        });
        return found.build().toArray();
    }

    private void enclose(int[] walls, int solid, int[] contents) {
        long pairs = (long) walls.length * IntStream.of(contents).mapToLong(s -> members.of(s).length).sum();
        boolean isDark = pairs <= MOST_PAIRS && IntStream.of(walls).allMatch(f -> sides[faces.triangle(f)] == 1)
                && !lights.any(shells.box, 6 * solid, (before, behind) -> SolidAngle.isInSolid(faces, before, walls)
                && SolidAngle.isInSolid(faces, behind, walls));
        for (int s : contents) {
            if (isDark) {
                enclose(walls, members.of(s));
            }
        }
    }

    /** Notes which faces of a shell are inside a solid, if the shell is: each face is, or is on the solid's border. */
    private void enclose(int[] walls, int[] some) {
        BitSet found = new BitSet();
        for (int f : some) {
            if (isInside(f, walls, false)) {
                found.set(f);
            } else if (!isInside(f, walls, true)) {
                return;
            }
        }
        inside.or(found);
    }

    /** Whether all places a little in front of a face, or behind the face, are inside a solid. */
    private boolean isInside(int face, int[] walls, boolean behind) {
        return IntStream.range(0, SolidAngle.PLACES).allMatch(place -> SolidAngle.isInSolid(faces,
                behind ? SolidAngle.behind(faces, face, place) : SolidAngle.before(faces, face, place), walls));
    }
}
