package radiosity.mesh.cut;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;

/**
 * Finds lines behind the mouths of narrow gaps, as between a wall and the back of a cupboard, on both sides of the gap.
 *
 * <p>In a gap light goes to and fro between the sides, and fades within few widths of the gap. Elements that are larger
 * would carry light as far as they are large at each reflection: linear interpolation brings the light of a lit corner
 * to where the other side gathers it, which carries it on. Refinement finds no error there, as both sides agree. Lines
 * at distances that grow with the depth make few elements that are narrow where the light fades.
 */
final class GapBands {

    /** Least length of a mouth, in widths of its gap. */
    private static final double LONG = 4;
    /** Cosine between the normal of a side of a gap and the way to the other side, above which they are parallel. */
    private static final double PARALLEL = 0.9;
    /** Part of the light at the mouth to which it fades within the reach of the mouth. */
    private static final double LEFT = 0.01;
    /** Most mouths that count, the longest first, as each is worth many pieces. */
    private static final int MOST = 512;
    /** Lines nearer to each other than this part of the width are one. */
    private static final double SAME = 0.25;

    private final Faces faces;
    private final Scene scene;
    private final List<Mouth> mouths;
    /** Boxes around {@link #mouths}, each grown by the distance of its last line and the width of its gap. */
    private final BoxTree near;

    /**
     * An edge of a face that another surface faces near by.
     *
     * @param inside direction from the edge into its face, length 1
     * @param width  distance to the other surface, scene units
     * @param reach  distance from the edge within which light fades, scene units: the first line beyond is the last
     */
    private record Mouth(int face, Vec3 from, Vec3 to, Vec3 inside, double width, double reach) {

        double length() {
            return to.minus(from).length();
        }
    }

    /** @param least length of the shortest mouth, scene units */
    GapBands(Faces faces, double least) {
        this.faces = faces;
        scene = faces.scene();
        TriangleBoxes boxes = TriangleBoxes.upright(scene);
        List<Mouth> all = new ArrayList<>();
        for (int f = 0; f < faces.count(); f++) {
            for (int k = 0; k < 3; k++) {
                if (faces.isBorder(f, k)) {
                    addMouth(f, k, least, boxes, all);
                }
            }
        }
        all.sort(Comparator.<Mouth>comparingDouble(mouth -> -(float) mouth.length())
                .thenComparing(Mouth::from, EdgeBands.PLACES).thenComparing(Mouth::to, EdgeBands.PLACES));
        mouths = List.copyOf(all.subList(0, Math.min(MOST, all.size())));
        near = boxes(mouths);
    }

    private GapBands(Faces faces, List<Mouth> mouths) {
        this.faces = faces;
        scene = faces.scene();
        this.mouths = mouths;
        near = boxes(mouths);
    }

    /** Number of mouths that count. */
    int mouths() {
        return mouths.size();
    }

    /** The bands behind the longest mouths only, a number of them. */
    GapBands longest(int count) {
        return new GapBands(faces, mouths.subList(0, count));
    }

    private static BoxTree boxes(List<Mouth> mouths) {
        double[] box = new double[6 * mouths.size()];
        for (int i = 0; i < mouths.size(); i++) {
            Mouth mouth = mouths.get(i);
            double[] around = EdgeBands.box(mouth.from(), mouth.to());
            for (int a = 0; a < 3; a++) {
                box[6 * i + a] = around[a] - 2 * mouth.reach() - mouth.width();
                box[6 * i + 3 + a] = around[3 + a] + 2 * mouth.reach() + mouth.width();
            }
        }
        return new BoxTree(box);
    }

    private void addMouth(int f, int k, double least, TriangleBoxes boxes, List<Mouth> to) {
        Vec3 p = faces.sceneCorner(f, (k + 1) % 3);
        Vec3 q = faces.sceneCorner(f, (k + 2) % 3);
        double length = q.minus(p).length();
        if (length <= least) {
            return;
        }
        boolean isTurned = EdgeBands.PLACES.compare(p, q) > 0;
        Vec3 along = q.minus(p).times(1 / length);
        Vec3 n = faces.exactNormal(f);
        Vec3 inside = n.cross(along).unit();
        double far = length / LONG;
        Vec3 x = p.plus(q).times(0.5).plus(inside.times(far / LONG / LONG));
        Vec3 end = x.plus(n.times(far));
        double width = far;
        int opposite = -1;
        for (int t : boxes.reaching(EdgeBands.box(x, end), 0, 0)) {
            double distance = distance(t, x, n);
            if (distance < width && distance > Faces.COVERING * faces.size()) {
                width = distance;
                opposite = t;
            }
        }
        if (opposite >= 0) {
            double rho = Math.sqrt(scene.surface(opposite).reflectance().max()
                    * scene.surface(faces.triangle(f)).reflectance().max());
            if (depth(rho) > 1) {
                to.add(new Mouth(f, isTurned ? q : p, isTurned ? p : q, inside, width, width * depth(rho)));
            }
        }
    }

    /**
     * Number of widths of a gap within which its light fades to {@link #LEFT}. Between parallel planes of reflectance
     * rho light spreads by diffusion: B = rho (B + w² B'' / 2), if w² is the mean square of the way along the planes
     * from one reflection to the next, so B fades by e within w sqrt(rho / (2 (1 - rho))). The width of the
     * gap is taken for w.
     */
    private static double depth(double rho) {
        return -StrictMath.log(LEFT) * Math.sqrt(rho / (2 * (1 - rho)));
    }

    /** Distance from a point to a triangle that faces the point, in a direction; infinite where it is not met. */
    private double distance(int t, Vec3 x, Vec3 direction) {
        Vec3 m = scene.cross(t).unit();
        double cosine = m.dot(direction);
        if (!(scene.surface(t).twoSided() ? Math.abs(cosine) > PARALLEL : cosine < -PARALLEL)) {
            return Double.POSITIVE_INFINITY;
        }
        double distance = scene.corner(t, 0).minus(x).dot(m) / cosine;
        Vec3 met = x.plus(direction.times(distance));
        for (int k = 0; k < 3; k++) {
            Vec3 corner = scene.corner(t, k);
            if (scene.corner(t, (k + 1) % 3).minus(corner).cross(met.minus(corner)).dot(m) < 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return distance;
    }

    /** The lines on a face: on the side of a gap that has the mouth, and on the side that faces it. */
    List<Contact> on(int face) {
        Vec3 n = faces.exactNormal(face);
        Vec3 origin = faces.sceneCorner(face, 0);
        double[] box = EdgeBands.box(origin, faces.sceneCorner(face, 1), faces.sceneCorner(face, 2));
        List<Integer> found = new ArrayList<>();
        near.any(BoxTree.overlapping(box, 0, 0), i -> {
            found.add(i);
            return false;
        });
        found.sort(null);
        List<Contact> lines = new ArrayList<>();
        for (int i : found) {
            Mouth mouth = mouths.get(i);
            double height = mouth.from().minus(origin).dot(n);
            boolean isOwn = faces.part[mouth.face()] == faces.part[face];
            boolean isOpposite = faces.exactNormal(mouth.face()).dot(n) < -PARALLEL
                    && height > mouth.width() / 2 && height < 2 * mouth.width();
            if (isOwn || isOpposite) {
                addLines(mouth, n, height, lines);
            }
        }
        return lines;
    }

    /** Adds lines behind a mouth, at distances that are doubled up to the first beyond its reach. */
    private static void addLines(Mouth mouth, Vec3 n, double height, List<Contact> lines) {
        Vec3 across = n.cross(mouth.to().minus(mouth.from())).unit();
        double side = Math.signum(across.dot(mouth.inside()));
        for (double distance = mouth.width(); distance < 2 * mouth.reach(); distance *= 2) {
            Vec3 step = across.times(side * distance).minus(n.times(height));
            Contact line = new Contact(mouth.from().plus(step), mouth.to().plus(step), across);
            if (!EdgeBands.isAmong(lines, line, SAME * mouth.width())) {
                lines.add(line);
            }
        }
    }
}
