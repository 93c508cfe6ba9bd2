package radiosity.mesh.face;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;

/** Divides edges that match only in pieces, where a corner of one face stands on an edge of another face. */
public final class EdgePieces {

    /** A point nearer to an edge than this stands on it, in scene sizes: about the precision of float coordinates. */
    private static final double ON_EDGE = 1e-7;
    /** Most edges that are divided; where there are more, none is. */
    private static final int MOST = 4000;

    private final Faces faces;
    private final double near;
    private final int[] points;
    /** Tree over the points. */
    private final BoxTree tree;

    /**
     * @param points points that may stand on edges; not modified
     * @param edges  number of edges that will be divided
     */
    public EdgePieces(Faces faces, int[] points, int edges) {
        this.faces = faces;
        near = ON_EDGE * faces.size();
        this.points = edges <= MOST ? points : new int[0];
        tree = BoxTree.ofPoints(IntStream.of(this.points).mapToObj(faces::place)
                .flatMapToDouble(at -> DoubleStream.of(at.x(), at.y(), at.z())).toArray());
    }

    /** The points of an edge in order: its first end, the points that stand on it, and its second end. */
    public int[] stops(int p, int q) {
        IntStream.Builder found = IntStream.builder();
        tree.near(coordinates(p), coordinates(q), 2 * near, found::add);
        int[] between = found.build().sorted().map(i -> points[i]).filter(x -> x != p && x != q && isOn(p, q, x))
                .toArray();
        Integer[] sorted = Arrays.stream(between).boxed().toArray(Integer[]::new);
        Arrays.sort(sorted, (x, y) -> Double.compare(along(p, q, x), along(p, q, y)));
        int[] stops = new int[sorted.length + 2];
        stops[0] = p;
        for (int i = 0; i < sorted.length; i++) {
            stops[i + 1] = sorted[i];
        }
        stops[stops.length - 1] = q;
        return stops;
    }

    private double[] coordinates(int p) {
        Vec3 at = faces.place(p);
        return new double[] {at.x(), at.y(), at.z()};
    }

    private boolean isOn(int p, int q, int x) {
        double length = Math.sqrt(dot(p, q, q));
        double at = along(p, q, x);
        double off2 = dot(p, x, x) - at * at;
        return at > near && at < length - near && off2 <= near * near;
    }

    /** Position of a point along an edge, scene units from its first end. */
    private double along(int p, int q, int x) {
        return dot(p, q, x) / Math.sqrt(dot(p, q, q));
    }

    private double dot(int from, int x, int y) {
        Vec3 start = faces.place(from);
        return faces.place(x).minus(start).dot(faces.place(y).minus(start));
    }
}
