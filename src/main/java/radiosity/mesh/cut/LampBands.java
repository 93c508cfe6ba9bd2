package radiosity.mesh.cut;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;

/**
 * Finds lines on faces that long lamps hang close to, such as a shelf with a strip of light-emitting diodes below.
 *
 * <p>Across such a lamp the irradiance changes within the lamp's height above the face, and along the lamp it hardly
 * changes. Elements of equal sides that are as small as the height would be as many as the lamp is long; bands between
 * these lines, whose widths grow with the distance from the lamp's edge, become elements that are long and narrow.
 */
final class LampBands {

    /**
     * A lamp's edge is long if it runs along a region of faces for more than this number of its heights above them:
     * that is the number of elements of equal sides for which one band stands.
     */
    private static final double LONG = 32;
    /** Distances of the lines from the foot of a lamp's edge, on both sides, in heights of the edge above the face. */
    private static final double[] DISTANCES = {0, .5, 1, 2, 4};
    private static final double FARTHEST = DISTANCES[DISTANCES.length - 1];
    /** A line nearer to another than this is left out, in heights. */
    private static final double SAME = .25;

    private final Faces faces;
    /** Faces that emit, once for each of their edges on the border of their coplanar region. */
    private final List<LampEdge> edges = new ArrayList<>();
    /** Boxes around {@link #edges}, each grown by the distance from which the edge may have lines on a face. */
    private final BoxTree near;
    private final double least;
    /** Low x, y, z, high x, y, z of the current region. */
    private double[] region = new double[6];

    /** An edge of a face that emits, scene units. */
    private record LampEdge(int face, Vec3 from, Vec3 to) {

        double length() {
            return to.minus(from).length();
        }

        /** Length of the part of the edge that runs along a box. */
        double along(double[] box) {
            Vec3 direction = to.minus(from).unit();
            double low = 0;
            double high = 0;
            for (int a = 0; a < 3; a++) {
                double d = direction.coordinate(a);
                low += d * ((d > 0 ? box[a] : box[3 + a]) - from.coordinate(a));
                high += d * ((d > 0 ? box[3 + a] : box[a]) - from.coordinate(a));
            }
            return Math.min(high, length()) - Math.max(low, 0);
        }
    }

    /** The foot of an edge on the plane of a face, and the edge's height above that plane, scene units. */
    private record Foot(Vec3 from, Vec3 to, double height) {
    }

    /** @param least length along which an edge must run beside faces to get lines, scene units */
    LampBands(Faces faces, double least) {
        this.faces = faces;
        this.least = least;
        for (int f = 0; f < faces.count(); f++) {
            for (int k = 0; k < 3 && faces.emits(f); k++) {
                LampEdge edge = new LampEdge(f, faces.sceneCorner(f, (k + 1) % 3), faces.sceneCorner(f, (k + 2) % 3));
                if (faces.isBorder(f, k) && edge.length() > least) {
                    edges.add(edge);
                }
            }
        }
        double[] boxes = new double[6 * edges.size()];
        for (int i = 0; i < edges.size(); i++) {
            LampEdge edge = edges.get(i);
            double reach = (1 + FARTHEST) * edge.length() / LONG;
            for (int a = 0; a < 3; a++) {
                double p = edge.from().coordinate(a);
                double q = edge.to().coordinate(a);
                boxes[6 * i + a] = Math.min(p, q) - reach;
                boxes[6 * i + 3 + a] = Math.max(p, q) + reach;
            }
        }
        near = new BoxTree(boxes);
    }

    /** Prepares for the faces of a coplanar region. */
    void begin(List<Integer> part) {
        region = box(part.stream().flatMap(f -> IntStream.range(0, 3).mapToObj(k -> faces.sceneCorner(f, k)))
                .toArray(Vec3[]::new));
    }

    /** The lines on one face of the region, those of the edges nearest to the face first. */
    List<Contact> on(int face) {
        Vec3 n = faces.exactNormal(face);
        Vec3[] corners = {faces.sceneCorner(face, 0), faces.sceneCorner(face, 1), faces.sceneCorner(face, 2)};
        List<Foot> feet = new ArrayList<>();
        near.any(BoxTree.overlapping(box(corners), 0, 0), i -> {
            LampEdge edge = edges.get(i);
            double height = height(edge, corners, n);
            if (height > Faces.COVERING * faces.size() && edge.along(region) > Math.max(least, LONG * height)) {
                feet.add(new Foot(below(edge.from(), corners[0], n), below(edge.to(), corners[0], n), height));
            }
            return false;
        });
        feet.sort(Comparator.comparingDouble(Foot::height));
        List<Contact> lines = new ArrayList<>();
        feet.forEach(foot -> add(foot, n, lines));
        return lines;
    }

    private static double[] box(Vec3... points) {
        double[] box = new double[6];
        for (int a = 0; a < 3; a++) {
            int axis = a;
            box[a] = Arrays.stream(points).mapToDouble(p -> p.coordinate(axis)).min().orElseThrow();
            box[3 + a] = Arrays.stream(points).mapToDouble(p -> p.coordinate(axis)).max().orElseThrow();
        }
        return box;
    }

    /** Height of an edge above a face's plane, 0 where no light of the edge's face can reach the face. */
    private double height(LampEdge edge, Vec3[] corners, Vec3 n) {
        double low = edge.from().minus(corners[0]).dot(n);
        double high = edge.to().minus(corners[0]).dot(n);
        Vec3 forward = faces.exactNormal(edge.face());
        double before = 0;
        for (Vec3 corner : corners) {
            before = Math.max(before, corner.minus(edge.from()).dot(forward));
        }
        return before <= Faces.NEAR * faces.size() || Math.min(low, high) < 0 ? 0 : Math.max(low, high);
    }

    private static Vec3 below(Vec3 p, Vec3 origin, Vec3 n) {
        return p.minus(n.times(p.minus(origin).dot(n)));
    }

    private static void add(Foot foot, Vec3 n, List<Contact> lines) {
        Vec3 across = n.cross(foot.to().minus(foot.from())).unit();
        for (double distance : DISTANCES) {
            for (int side = -1; side <= 1; side += 2) {
                Vec3 shift = across.times(side * distance * foot.height());
                Vec3 from = foot.from().plus(shift);
                Vec3 to = foot.to().plus(shift);
                double same = SAME * foot.height();
                if (lines.stream().noneMatch(line -> line.holds(from, same) && line.holds(to, same))) {
                    lines.add(new Contact(from, to, across));
                }
            }
        }
    }
}
