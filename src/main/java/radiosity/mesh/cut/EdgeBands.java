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
 * Finds lines on faces that long edges of other faces hang close to: a strip of light-emitting diodes below a shelf, a
 * rug on a floor, a picture on a wall, a door above its sill.
 *
 * <p>Across such an edge the irradiance changes within the edge's height above the face, and along the edge it hardly
 * changes. Elements of equal sides that are as small as the height would be as many as the edge is long; bands between
 * these lines become elements that are long and narrow. A lamp shines on the face from there on, and its bands grow
 * with the distance from the edge; of other edges there are the two ends of what they shade partly.
 */
final class EdgeBands {

    /**
     * An edge is long if it runs along a region of faces for more than this number of its heights above them: that is
     * the number of elements of equal sides for which one band stands.
     */
    private static final double LONG = 32;
    /** Distances of the lines from the foot of an edge, on both sides, in heights of the edge above the face. */
    private static final double[] OF_LAMPS = {0, .5, 1, 2, 4};
    private static final double[] OF_SHADOWS = {1};
    private static final double FARTHEST = OF_LAMPS[OF_LAMPS.length - 1];
    /** A line nearer to another than this is left out, in heights. */
    private static final double SAME = .25;

    static final Comparator<Vec3> PLACES = Comparator.comparingDouble(Vec3::x).thenComparingDouble(Vec3::y)
            .thenComparingDouble(Vec3::z);
    /** The lowest edges first, as floats, as the heights of equal edges differ by rounding. */
    private static final Comparator<Foot> LOWEST = Comparator.<Foot>comparingDouble(foot -> (float) foot.height())
            .thenComparing(Foot::from, PLACES).thenComparing(Foot::to, PLACES);

    private final Faces faces;
    /** The edges on borders of coplanar regions. */
    private final List<Edge> edges = new ArrayList<>();
    /** Boxes around {@link #edges}, each grown by the distance from which the edge may have lines on a face. */
    private final BoxTree near;
    /** Low x, y, z, high x, y, z of the current region. */
    private double[] region = new double[6];

    /** An edge of a face, scene units. */
    private record Edge(int face, Vec3 from, Vec3 to) {

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
    private record Foot(Vec3 from, Vec3 to, double height, boolean isLamp) {

        Contact line(Vec3 n, double across) {
            Vec3 beside = n.cross(to.minus(from)).unit();
            return new Contact(from.plus(beside.times(across)), to.plus(beside.times(across)), beside);
        }
    }

    /** @param least length of the shortest edge that may have lines, scene units */
    EdgeBands(Faces faces, double least) {
        this.faces = faces;
        for (int f = 0; f < faces.count(); f++) {
            for (int k = 0; k < 3; k++) {
                Edge edge = edge(f, faces.sceneCorner(f, (k + 1) % 3), faces.sceneCorner(f, (k + 2) % 3));
                if (faces.isBorder(f, k) && edge.length() > least) {
                    edges.add(edge);
                }
            }
        }
        double[] boxes = new double[6 * edges.size()];
        for (int i = 0; i < edges.size(); i++) {
            Edge edge = edges.get(i);
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

    /** An edge in one direction, whatever the order of a polygon's corners is: the same scene has the same lines. */
    private static Edge edge(int face, Vec3 p, Vec3 q) {
        return PLACES.compare(p, q) <= 0 ? new Edge(face, p, q) : new Edge(face, q, p);
    }

    /** Prepares for the faces of a coplanar region. */
    void begin(List<Integer> part) {
        region = box(part.stream().flatMap(f -> IntStream.range(0, 3).mapToObj(k -> faces.sceneCorner(f, k)))
                .toArray(Vec3[]::new));
    }

    /**
     * The lines on one face of the region, those of the edges nearest to the face first.
     *
     * @param least length along which an edge must run beside the region to have lines, scene units
     */
    List<Contact> on(int face, double least) {
        Vec3 n = faces.exactNormal(face);
        Vec3[] corners = {faces.sceneCorner(face, 0), faces.sceneCorner(face, 1), faces.sceneCorner(face, 2)};
        List<Foot> feet = new ArrayList<>();
        near.any(BoxTree.overlapping(box(corners), 0, 0), i -> {
            Edge edge = edges.get(i);
            double height = height(edge, corners[0], n);
            if (height > Faces.COVERING * faces.size() && edge.along(region) > Math.max(least, LONG * height)) {
                feet.add(new Foot(below(edge.from(), corners[0], n), below(edge.to(), corners[0], n), height,
                        shines(edge, corners)));
            }
            return false;
        });
        feet.sort(LOWEST);
        List<Contact> lines = new ArrayList<>();
        List<Contact> shaded = new ArrayList<>();
        for (Foot foot : feet) {
            Contact middle = foot.line(n, 0);
            if (foot.isLamp()) {
                add(foot, OF_LAMPS, n, lines);
            } else if (!isAmong(shaded, middle, SAME * foot.height())) { // an edge below hides the edge
                add(foot, OF_SHADOWS, n, lines);
                shaded.add(middle);
            }
        }
        return lines;
    }

    /** The box around some points: low x, y, z, high x, y, z. */
    static double[] box(Vec3... points) {
        double[] box = new double[6];
        for (int a = 0; a < 3; a++) {
            int axis = a;
            box[a] = Arrays.stream(points).mapToDouble(p -> p.coordinate(axis)).min().orElseThrow();
            box[3 + a] = Arrays.stream(points).mapToDouble(p -> p.coordinate(axis)).max().orElseThrow();
        }
        return box;
    }

    /** Height of an edge above a plane; 0 where an end is at less than half the height of the other, or below. */
    private static double height(Edge edge, Vec3 origin, Vec3 n) {
        double from = edge.from().minus(origin).dot(n);
        double to = edge.to().minus(origin).dot(n);
        return 2 * Math.min(from, to) < Math.max(from, to) ? 0 : Math.max(from, to);
    }

    /** Whether the face of an edge emits light that can reach a face, which has these corners. */
    private boolean shines(Edge edge, Vec3... corners) {
        Vec3 forward = faces.exactNormal(edge.face());
        return faces.emits(edge.face()) && Arrays.stream(corners)
                .anyMatch(corner -> corner.minus(edge.from()).dot(forward) > Faces.NEAR * faces.size());
    }

    private static Vec3 below(Vec3 p, Vec3 origin, Vec3 n) {
        return p.minus(n.times(p.minus(origin).dot(n)));
    }

    private static void add(Foot foot, double[] distances, Vec3 n, List<Contact> lines) {
        for (double distance : distances) {
            for (int side = -1; side <= 1; side += 2) {
                Contact line = foot.line(n, side * distance * foot.height());
                if (!isAmong(lines, line, SAME * foot.height())) {
                    lines.add(line);
                }
            }
        }
    }

    /** Whether a line lies along another, no farther from it than a distance. */
    static boolean isAmong(List<Contact> lines, Contact line, double same) {
        return lines.stream().anyMatch(other -> other.reaches(line.from(), same) && other.reaches(line.to(), same));
    }
}
