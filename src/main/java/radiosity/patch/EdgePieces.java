package radiosity.patch;

import java.util.Arrays;

/**
 * Edges that fit together only in pieces: where a corner of one face stands on an edge of another.
 *
 * <p>Source of the idea: a chain of edges has no boundary if its pieces cancel.
 */
final class EdgePieces {

    /** A point this near to an edge stands on it, of the scene's size: what coordinates in floats can tell. */
    private static final double ON_EDGE = 1e-7;
    /** Loose edges that are looked at; where there are more, they stay loose. */
    private static final int MOST = 4000;

    private final double[] point;
    private final double near;
    private final int[] ends;
    private final int[] edges;

    /** Told of two edges that share a piece. */
    interface Meeting {
        void meet(int edge, int other);
    }

    /**
     * @param ends  2 per edge: points, the lower number first; not modified
     * @param loose the edges to look at; not modified
     */
    EdgePieces(Faces faces, int[] ends, int[] loose) {
        point = faces.scene().points();
        near = ON_EDGE * faces.size();
        this.ends = ends;
        edges = loose.length <= MOST ? loose : new int[0];
    }

    static long key(int p, int q) {
        return (long) Math.min(p, q) << 32 | Math.max(p, q);
    }

    /** @param net 1 per edge, modified: how often it is run through from its lower end; 0 where its pieces cancel */
    void balance(int[] net, Meeting meeting) {
        int[] points = Arrays.stream(edges).flatMap(e -> Arrays.stream(ends, 2 * e, 2 * e + 2)).distinct().toArray();
        int[][] pieces = new int[edges.length][];
        LongIndex index = new LongIndex(2 * edges.length);
        int[] sum = new int[64];
        int[] first = new int[64];
        for (int i = 0; i < edges.length; i++) {
            int[] stops = stops(edges[i], points);
            pieces[i] = new int[stops.length - 1];
            for (int k = 0; k < pieces[i].length; k++) {
                int known = index.size();
                int piece = index.findOrAdd(key(stops[k], stops[k + 1]), known);
                if (piece == sum.length) {
                    sum = Arrays.copyOf(sum, 2 * piece);
                    first = Arrays.copyOf(first, 2 * piece);
                }
                if (piece == known) {
                    first[piece] = edges[i];
                }
                meeting.meet(first[piece], edges[i]);
                sum[piece] += stops[k] < stops[k + 1] ? net[edges[i]] : -net[edges[i]];
                pieces[i][k] = piece;
            }
        }
        for (int i = 0; i < edges.length; i++) {
            int[] of = sum;
            net[edges[i]] = Arrays.stream(pieces[i]).allMatch(piece -> of[piece] == 0) ? 0 : net[edges[i]];
        }
    }

    /** The ends of an edge, and what stands on it between them, from its lower end on. */
    private int[] stops(int edge, int[] points) {
        int p = ends[2 * edge];
        int q = ends[2 * edge + 1];
        int[] between = Arrays.stream(points).filter(x -> x != p && x != q && isOn(p, q, x)).toArray();
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

    private boolean isOn(int p, int q, int x) {
        double length = Math.sqrt(dot(p, q, q));
        double at = along(p, q, x);
        double off2 = dot(p, x, x) - at * at;
        return at > near && at < length - near && off2 <= near * near;
    }

    /** How far along an edge a point lies, scene units. */
    private double along(int p, int q, int x) {
        return dot(p, q, x) / Math.sqrt(dot(p, q, q));
    }

    private double dot(int from, int x, int y) {
        double sum = 0;
        for (int a = 0; a < 3; a++) {
            sum += (point[3 * x + a] - point[3 * from + a]) * (point[3 * y + a] - point[3 * from + a]);
        }
        return sum;
    }
}
