package radiosity.mesh.room;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiPredicate;
import radiosity.mesh.face.Faces;
import radiosity.scene.Light;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;

/** Places of sources of light and of the camera: no closed body with such a place inside is dark and unseen. */
final class LightPlaces {

    private final Faces faces;
    /** x, y, z in the scene brought to size 1: places a little in front of faces that emit, lights and the camera. */
    private final List<double[]> before = new ArrayList<>();
    /** For each place, the place behind the same face; the same place where there is no face. */
    private final List<double[]> behind = new ArrayList<>();
    private final BoxTree tree;

    LightPlaces(Faces faces) {
        this.faces = faces;
        for (int f = 0; f < faces.count(); f++) {
            for (int place = 0; place < SolidAngle.PLACES && faces.emits(f); place++) {
                before.add(SolidAngle.before(faces, f, place));
                behind.add(SolidAngle.behind(faces, f, place));
            }
        }
        for (Light light : faces.scene().lights()) {
            if (!light.kind().isOutside()) {
                add(light.position());
            }
        }
        faces.scene().camera().ifPresent(camera -> add(camera.position()));
        tree = BoxTree.ofPoints(before.stream().flatMapToDouble(Arrays::stream).toArray());
    }

    private void add(Vec3 place) {
        Vec3 at = faces.unit(place);
        before.add(new double[] {at.x(), at.y(), at.z()});
        behind.add(new double[] {at.x(), at.y(), at.z()});
    }

    /**
     * Whether a place in a box is inside a body.
     *
     * @param box    low x, y, z, high x, y, z, 6 from {@code of}; not modified
     * @param inside receives x, y, z of the place, and of the place behind the same face
     */
    boolean any(double[] box, int of, BiPredicate<double[], double[]> inside) {
        return tree.any(BoxTree.overlapping(box, of, 0),
                place -> inside.test(before.get(place), behind.get(place)));
    }
}
