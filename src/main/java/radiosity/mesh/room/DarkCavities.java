package radiosity.mesh.room;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.util.BoxTree;

/**
 * Finds closed bodies that are seen from inside, where neither a source of light nor the camera is: no light enters, so
 * they are black.
 *
 * <p>Such a body may be the inner sides of two-sided triangles, as of the bars of a window in a model whose surfaces
 * are all two-sided. Without these sides the bars are solids like those of one-sided triangles. A body of one-sided
 * triangles is inside out, unless it is the hollow of a solid, or a room without a lamp that holds the whole scene: the
 * corners of its triangles run the wrong way.
 */
public final class DarkCavities {

    private final Faces faces;
    private final FaceShells shells;
    private final FaceGroups members;
    private final LightPlaces lights;

    private DarkCavities(Faces faces) {
        this.faces = faces;
        shells = new FaceShells(faces);
        members = new FaceGroups(shells.shell);
        lights = new LightPlaces(faces);
    }

    /** The faces that are inner sides of dark bodies, by number; none where no surface is two-sided. */
    public static BitSet of(Faces faces) {
        BitSet dark = new BitSet();
        if (IntStream.range(0, faces.count()).noneMatch(f -> isTwoSided(faces, f))) {
            return dark;
        }
        DarkCavities all = new DarkCavities(faces);
        all.cavities(true).forEach(shell -> IntStream.of(all.members.of(shell)).forEach(dark::set));
        return dark;
    }

    /** The bodies of one-sided triangles that are inside out: the faces of each. */
    public static List<int[]> insideOut(Faces faces) {
        DarkCavities all = new DarkCavities(faces);
        double[] solids = IntStream.range(0, faces.count())
                .filter(f -> all.shells.shell[f] == f && all.shells.isWhole(f) && all.shells.volume[f] > 0)
                .mapToObj(f -> Arrays.copyOfRange(all.shells.box, 6 * f, 6 * f + 6)).flatMapToDouble(Arrays::stream)
                .toArray();
        BoxTree tree = new BoxTree(solids);
        double[] scene = all.extent();
        return all.cavities(false).filter(shell -> !holds(all.shells.box, 6 * shell, scene, 0))
                .filter(shell -> !tree.any(BoxTree.overlapping(all.shells.box, 6 * shell, 0),
                        solid -> holds(solids, 6 * solid, all.shells.box, 6 * shell)))
                .mapToObj(all.members::of).toList();
    }

    /** Box around all faces: low x, y, z, high x, y, z. */
    private double[] extent() {
        double[] box = Arrays.copyOf(shells.box, 6);
        for (int f = 0; f < faces.count(); f++) {
            for (int i = 0; i < 6 && shells.shell[f] == f; i++) {
                double at = shells.box[6 * f + i];
                box[i] = i < 3 ? Math.min(box[i], at) : Math.max(box[i], at);
            }
        }
        return box;
    }

    private static boolean holds(double[] boxes, int at, double[] others, int of) {
        return IntStream.range(0, 3).allMatch(a -> boxes[at + a] <= others[of + a]
                && boxes[at + 3 + a] >= others[of + 3 + a]);
    }

    private IntStream cavities(boolean twoSided) {
        return IntStream.range(0, faces.count()).filter(f -> shells.shell[f] == f && isDark(f, twoSided));
    }

    private static boolean isTwoSided(Faces faces, int face) {
        return faces.scene().surface(faces.triangle(face)).twoSided();
    }

    private boolean isDark(int shell, boolean twoSided) {
        if (!shells.isWhole(shell) || shells.volume[shell] >= 0) {
            return false;
        }
        int[] walls = members.of(shell);
        return IntStream.of(walls).allMatch(f -> isTwoSided(faces, f) == twoSided && !faces.emits(f))
                && !lights.any(shells.box, 6 * shell, (before, behind) -> SolidAngle.isInside(faces, before, walls));
    }
}
