package radiosity.mesh.room;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.scene.Light;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;

/**
 * Finds the inner sides of closed bodies of two-sided triangles, such as the bars of a window in a model whose surfaces
 * are all two-sided. No light enters such a body, so where neither a source nor the camera is inside, its inner sides
 * are black and unseen. Without these sides the body is a solid like one of one-sided triangles.
 */
public final class DarkCavities {

    private final Faces faces;
    private final FaceShells shells;
    private final FaceGroups members;
    /** Places of sources of light and of the camera, in the scene brought to size 1. */
    private final List<double[]> places = new ArrayList<>();
    private final BoxTree tree;

    private DarkCavities(Faces faces) {
        this.faces = faces;
        shells = new FaceShells(faces);
        members = new FaceGroups(shells.shell);
        for (int f = 0; f < faces.count(); f++) {
            for (int place = 0; place < SolidAngle.PLACES && faces.emits(f); place++) {
                places.add(SolidAngle.before(faces, f, place));
            }
        }
        for (Light light : faces.scene().lights()) {
            if (!light.kind().isOutside()) {
                add(light.position());
            }
        }
        faces.scene().camera().ifPresent(camera -> add(camera.position()));
        tree = BoxTree.ofPoints(places.stream().flatMapToDouble(Arrays::stream).toArray());
    }

    private void add(Vec3 place) {
        Vec3 at = faces.unit(place);
        places.add(new double[] {at.x(), at.y(), at.z()});
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
        if (shells.open[shell] || shells.seesBacks[shell]) {
            return false;
        }
        int[] walls = members.of(shell);
        double volume = 0;
        double[] low = new double[3];
        double[] high = new double[3];
        Arrays.fill(low, Double.POSITIVE_INFINITY);
        Arrays.fill(high, Double.NEGATIVE_INFINITY);
        for (int f : walls) {
            if (!isTwoSided(faces, f) || faces.emits(f)) {
                return false;
            }
            volume += SolidAngle.volume(faces, f);
            for (int i = 0; i < 9; i++) {
                low[i % 3] = Math.min(low[i % 3], faces.corner[9 * f + i]);
                high[i % 3] = Math.max(high[i % 3], faces.corner[9 * f + i]);
            }
        }
        return volume < 0 && !tree.any((boxes, i) -> isWithin(boxes, i, low, high),
                place -> SolidAngle.isInside(faces, places.get(place), walls));
    }

    /** Whether a box of the tree overlaps a region on every axis. */
    private static boolean isWithin(double[] boxes, int i, double[] low, double[] high) {
        boolean overlaps = true;
        for (int a = 0; a < 3; a++) {
            overlaps &= boxes[i + a] <= high[a] && low[a] <= boxes[i + 3 + a];
        }
        return overlaps;
    }
}
