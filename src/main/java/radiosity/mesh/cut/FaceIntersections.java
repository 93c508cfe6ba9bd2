package radiosity.mesh.cut;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.face.CutPoints;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;
import radiosity.util.PointNumbers;

/** Finds the contacts along which triangles stand on a face, pass through it or end in its plane. */
final class FaceIntersections {

    /** A normal is along an axis of the scene if one of its components differs from 1 or -1 by less than this. */
    private static final double UPRIGHT = 1e-12;
    /**
     * Most contacts on one face; where there are more, the longest are kept. Each is compared with each piece of the
     * face, which takes seconds for so many.
     */
    private static final int MOST = 4096;

    private final Faces faces;
    private final CutPoints points;
    private final Scene scene;
    /** 1 per point of the scene: the lowest point with the same coordinates. */
    private final int[] numbers;
    /** 2 per triangle, front and back: its face, -1 where there is none. */
    private final int[] faceOf;
    private final double touch;
    private final double least;
    /** 6 per triangle: low x, y, z, high x, y, z, scene units, grown by {@link #touch}. */
    private final double[] box;
    /** Boxes of all triangles along the axes of the scene. */
    private final TriangleBoxes upright;
    /** The boxes used for the current region: along its plane where it is oblique and has many faces, else upright. */
    private TriangleBoxes boxes;
    private long looks;

    /** @param least length of the shortest contact that is found, scene units */
    FaceIntersections(Faces faces, CutPoints points, double least) {
        this.points = points;
        this.faces = faces;
        scene = faces.scene();
        numbers = PointNumbers.of(scene.points());
        touch = Faces.NEAR * faces.size();
        this.least = least;
        faceOf = IntStream.generate(() -> -1).limit(2L * scene.triangles()).toArray();
        for (int f = 0; f < faces.count(); f++) {
            faceOf[faces.side(f)] = f;
        }
        box = BoxTree.around(scene.triangles(), (t, k, a) -> scene.points()[3 * scene.corners()[3 * t + k] + a]);
        Arrays.setAll(box, i -> i % 6 < 3 ? box[i] - touch : box[i] + touch);
        upright = TriangleBoxes.upright(scene);
        boxes = upright;
    }

    /**
     * Prepares for the faces of a coplanar region. If they are many and oblique, boxes along their plane tell triangles
     * in the plane from triangles that stand on it; boxes along the axes of the scene do not.
     */
    void begin(List<Integer> part) {
        boxes = upright;
        Vec3 n = faces.exactNormal(part.stream().max(Comparator.comparingDouble(faces::area)).orElseThrow());
        boolean isUpright = Math.max(Math.abs(n.x()), Math.max(Math.abs(n.y()), Math.abs(n.z()))) > 1 - UPRIGHT;
        if (!isUpright && (double) part.size() * part.size() > scene.triangles()) {
            boxes = TriangleBoxes.along(scene, boxes.reaching(around(part), 0, 2 * touch), n);
        }
    }

    /** The box around a coplanar region: low x, y, z, high x, y, z, scene units. */
    private double[] around(List<Integer> part) {
        double[] around = new double[6];
        for (int a = 0; a < 3; a++) {
            int axis = a;
            around[a] = part.stream().mapToDouble(f -> box[6 * faces.triangle(f) + axis]).min().orElseThrow();
            around[3 + a] = part.stream().mapToDouble(f -> box[6 * faces.triangle(f) + 3 + axis]).max().orElseThrow();
        }
        return around;
    }

    /** Number of boxes that were tested in searches for triangles; read by tests. */
    long looks() {
        return looks;
    }

    /** The contacts on one face, longest first, also those that touch its border only. */
    List<Contact> on(int face) {
        List<Contact> found = new ArrayList<>();
        int own = faces.triangle(face);
        Vec3 n = faces.exactNormal(face);
        Vec3 origin = faces.sceneCorner(face, 0);
        long before = boxes.looks();
        int[] near = boxes.reaching(box, 6 * own, 2 * touch, origin, n);
        looks += boxes.looks() - before;
        for (int t : near) {
            if (t != own && overlap(own, t)) {
                Contact contact = contact(t, origin, n);
                if (contact != null && contact.length() > least) {
                    found.add(contact);
                }
            }
        }
        for (int t : boxes.reaching(box, 6 * own, Faces.COVERING * faces.size())) {
            addOutline(t, face, origin, n, found);
        }
        found.sort(Comparator.comparingDouble(contact -> -contact.length()));
        return found.subList(0, Math.min(MOST, found.size()));
    }

    /** Adds the border edges of a triangle of another region that lies on a face and looks the same way. */
    private void addOutline(int t, int face, Vec3 origin, Vec3 n, List<Contact> found) {
        for (int back = 0; back < 2; back++) {
            int other = faceOf[2 * t + back];
            boolean isInPlace = other >= 0 && faces.part[other] != faces.part[face] && lies(t, origin, n)
                    && faces.exactNormal(other).dot(n) > 0;
            for (int k = 0; k < 3 && isInPlace; k++) {
                Vec3 from = dropped(faces.sceneCorner(other, (k + 1) % 3), origin, n);
                Vec3 to = dropped(faces.sceneCorner(other, (k + 2) % 3), origin, n);
                if (faces.isBorder(other, k) && to.minus(from).length() > least) {
                    found.add(new Contact(from, to, n.cross(to.minus(from)).unit()));
                }
            }
        }
    }

    /** The point of a plane below a point; the point itself where it lies in the plane. */
    private Vec3 dropped(Vec3 p, Vec3 origin, Vec3 n) {
        double above = p.minus(origin).dot(n);
        return Math.abs(above) <= touch ? p : p.minus(n.times(above));
    }

    /** Whether a triangle lies in a plane, or so little above that the triangle covers what is in the plane. */
    private boolean lies(int t, Vec3 origin, Vec3 n) {
        boolean lies = true;
        for (int k = 0; k < 3; k++) {
            double above = scene.corner(t, k).minus(origin).dot(n);
            lies &= above >= -touch && above <= Faces.COVERING * faces.size();
        }
        return lies;
    }

    private boolean overlap(int s, int t) {
        for (int a = 0; a < 3; a++) {
            if (box[6 * s + a] > box[6 * t + 3 + a] || box[6 * t + a] > box[6 * s + 3 + a]) {
                return false;
            }
        }
        return true;
    }

    /** A triangle's contact with a plane; null where they share no segment or no corner is in front of the plane. */
    private Contact contact(int t, Vec3 origin, Vec3 n) {
        double[] above = new double[3];
        double highest = 0;
        for (int k = 0; k < 3; k++) {
            double d = scene.corner(t, k).minus(origin).dot(n);
            above[k] = Math.abs(d) <= touch ? 0 : d;
            highest = Math.max(highest, above[k]);
        }
        Vec3[] end = new Vec3[2];
        int ends = 0;
        for (int k = 0; k < 3 && highest > 0; k++) {
            int next = (k + 1) % 3;
            if (above[k] == 0 && ends < 2) {
                points.use(numbers[scene.corners()[3 * t + k]]);
                end[ends++] = scene.corner(t, k);
            } else if (above[k] * above[next] < 0 && ends < 2) {
                end[ends++] = crossing(t, above, k, next);
            }
        }
        if (ends < 2 || end[0].equals(end[1])) {
            return null;
        }
        return new Contact(end[0], end[1], n.cross(end[1].minus(end[0])).unit());
    }

    /** The point where an edge meets the plane, the same to the last bit for both directions of the edge. */
    private Vec3 crossing(int t, double[] above, int k, int next) {
        boolean turn = numbers[scene.corners()[3 * t + k]] > numbers[scene.corners()[3 * t + next]];
        int from = turn ? next : k;
        int to = turn ? k : next;
        Vec3 p = scene.corner(t, from);
        return p.plus(scene.corner(t, to).minus(p).times(above[from] / (above[from] - above[to])));
    }
}
