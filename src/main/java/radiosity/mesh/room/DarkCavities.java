package radiosity.mesh.room;

import java.util.BitSet;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;

/**
 * Finds the inner sides of closed bodies of two-sided triangles, such as the bars of a window in a model whose surfaces
 * are all two-sided. No light enters such a body, so where neither a source nor the camera is inside, its inner sides
 * are black and unseen. Without these sides the body is a solid like one of one-sided triangles.
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
        for (int f = 0; f < faces.count(); f++) {
            if (all.shells.shell[f] == f && all.isDark(f)) {
                IntStream.of(all.members.of(f)).forEach(dark::set);
            }
        }
        return dark;
    }

    private static boolean isTwoSided(Faces faces, int face) {
        return faces.scene().surface(faces.triangle(face)).twoSided();
    }

    private boolean isDark(int shell) {
        if (!shells.isWhole(shell) || shells.volume[shell] >= 0) {
            return false;
        }
        int[] walls = members.of(shell);
        return IntStream.of(walls).allMatch(f -> isTwoSided(faces, f) && !faces.emits(f))
                && !lights.any(shells.box, 6 * shell, (before, behind) -> SolidAngle.isInside(faces, before, walls));
    }
}
