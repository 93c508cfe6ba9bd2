package radiosity.output.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.IntStream;
import radiosity.solution.Solution;
import radiosity.util.Aabb;
import radiosity.util.ArraySize;
import radiosity.util.BoxTree;
import radiosity.util.DisjointSets;
import radiosity.util.EdgeKey;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/**
 * Closes the cracks at T-junctions: an element whose edge carries corners of smaller elements is split at these
 * corners.
 *
 * <p>Within a part (elements connected by shared vertices) the hanging vertex is shared and keeps its own irradiance.
 * Of a hanging vertex of another part, of the same surface or not, only the position is used; the irradiance is
 * interpolated along the edge, so that no light crosses from one surface to another. Elements and vertices are
 * processed in the order of their ids.
 *
 * <p>The irradiance of a hanging vertex differs from the one between the ends of its edge. The flux that this adds to
 * the split element is taken from all vertices of the element, so that no flux is gained or lost.
 */
public final class TJunctions {

    /*
     * A crack can only open along an edge that is not shared by exactly two elements, and on both sides of a crack
     * there are open edges. So only the ends of open edges are sorted into a tree, and only open edges are searched for
     * vertices. Of n elements, about the square root of n have open edges where the mesh conforms; the cost is n log n
     * at worst.
     */

    /** Vertices nearer than this are one point, of the diagonal of the box of all elements: a few float roundings. */
    static final double TOLERANCE = 5e-7;

    private final Solution solution;
    /**
     * One {@link EdgeKey} of vertices per open edge, ascending: an edge that is not shared by exactly two elements, on
     * the border of a part or with a vertex hanging in it.
     */
    private final long[] open;
    private final double tolerance;
    private final DisjointSets parts;
    /**
     * 1 per vertex: at the end of an open edge the lowest such vertex at the same point, elsewhere the vertex itself.
     */
    private final int[] same;
    private final double[] positions;
    /** The vertex of a part at a point; the key is made of the part and of {@link #same}. */
    private final LongIndex vertexAt;
    private final List<Created> created = new ArrayList<>();
    private final IntStream.Builder corners = IntStream.builder();
    private final IntStream.Builder faceOf = IntStream.builder();
    /** Number of triangles in {@link #corners}. */
    private int triangles;
    /** Tree over the points at which open edges end. */
    private final BoxTree tree;
    /** 1 per point of the tree: the vertex that represents the point. */
    private final int[] ends;

    /**
     * A new vertex between two others.
     *
     * @param share  position between the two, 0 at {@code from} and 1 at {@code to}
     * @param values x, y, z, then irradiance per channel, W/m²
     */
    private record Created(int from, int to, double share, double[] values) { }

    private TJunctions(Solution solution) {
        this.solution = solution;
        positions = solution.positions().clone();
        open = openEdges(solution.corners());
        parts = new DisjointSets(solution.vertices(), solution.corners());
        tolerance = TOLERANCE * Aabb.of(positions).diagonal();
        same = new int[solution.vertices()];
        int[] atEdges = EdgeKey.ends(open);
        vertexAt = new LongIndex(atEdges.length);
        weld(atEdges);
        ends = IntStream.of(atEdges).filter(v -> same[v] == v).toArray();
        tree = tree(ends);
    }

    private static long[] openEdges(int[] corners) {
        long[] all = new long[corners.length];
        Arrays.setAll(all, i -> EdgeKey.of(corners[i], corners[i % 3 == 2 ? i - 2 : i + 1]));
        Arrays.sort(all);
        return EdgeKey.occurring(all, elements -> elements != 2);
    }

    private boolean isOpen(int a, int b) {
        return Arrays.binarySearch(open, EdgeKey.of(a, b)) >= 0;
    }

    private BoxTree tree(int[] vertices) {
        double[] points = new double[3 * vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            System.arraycopy(positions, 3 * vertices[i], points, 3 * i, 3);
        }
        return BoxTree.ofPoints(points);
    }

    /** Returns the same light on elements that meet corner to corner. Vertices keep their ids, elements may not. */
    public static Solution close(Solution solution) {
        return new TJunctions(solution).closed();
    }

    /**
     * Gives open vertices that are one point but for rounding the same position to the last bit.
     *
     * @param open the vertices at the ends of open edges, ascending; not modified
     */
    private void weld(int[] open) {
        Arrays.setAll(same, v -> v);
        int[] distinct = distinct(open);
        BoxTree all = tree(distinct);
        for (int v : distinct) {
            int near = all.lowest(point(v), tolerance);
            if (near >= 0) { // not where coordinates are so large that the point itself is not found
                same[v] = same[distinct[near]];
            }
        }
        for (int v : open) {
            same[v] = same[same[v]];
            System.arraycopy(positions, 3 * same[v], positions, 3 * v, 3);
            vertexAt.findOrAdd(key(v, same[v]), v);
        }
    }

    /** The lowest vertex at each position; it becomes {@link #same} of the other given vertices there. */
    private int[] distinct(int[] open) {
        LongIndex index = new LongIndex(open.length);
        return IntStream.of(open).filter(v -> {
            int first = index.findOrAdd(bits(v), v);
            same[v] = Arrays.equals(positions, 3 * first, 3 * first + 3, positions, 3 * v, 3 * v + 3) ? first : v;
            return same[v] == v;
        }).toArray();
    }

    /** Hash of a vertex's position. */
    private long bits(int vertex) {
        long bits = 0;
        for (int a = 0; a < 3; a++) {
            bits = Hash.mix(bits, Double.doubleToLongBits(positions[3 * vertex + a]));
        }
        return bits;
    }

    private double[] point(int vertex) {
        return Arrays.copyOfRange(positions, 3 * vertex, 3 * vertex + 3);
    }

    private long key(int vertexOfPart, int at) {
        return (long) parts.of(vertexOfPart) << 32 | at;
    }

    private Solution closed() {
        int[] c = solution.corners();
        int[] first = new int[solution.elements() + 1];
        for (int e = 0; e < solution.elements(); e++) {
            emit(e, new Polygon(c[3 * e], hanging(e, 0), c[3 * e + 1], hanging(e, 1), c[3 * e + 2], hanging(e, 2)));
            first[e + 1] = triangles;
        }
        Solution closed = new Solution(solution.scene(), solution.channels(), solution.lamps(),
                withCreated(positions, 0, 3), withCreated(solution.irradiance(), 3, solution.channels()),
                corners.build().toArray(), faceOf.build().toArray(), solution.shots(), solution.rounds(),
                solution.unshotFlux(), solution.ledger(), solution.state());
        keepFlux(first, closed);
        return closed;
    }

    /**
     * Takes from the vertices of every split element the flux that its hanging vertices have added. New vertices stay
     * between their neighbours.
     *
     * @param first  1 per element: its first triangle; then the number of triangles
     * @param closed its irradiance is modified; what is 0 or more stays so
     */
    private void keepFlux(int[] first, Solution closed) {
        int[] all = closed.corners();
        double[] area = new double[triangles];
        Arrays.setAll(area, t -> Elements.cross(closed, t).length() / 2);
        double[] around = new double[closed.vertices()];
        for (int i = 0; i < all.length; i++) {
            around[all[i]] += area[i / 3];
        }
        for (int c = 0; c < closed.channels(); c++) {
            double[] added = new double[around.length];
            for (int e = 0; e < solution.elements(); e++) {
                if (first[e + 1] - first[e] > 1) {
                    addGain(e, c, first, closed, area, added);
                }
            }
            takeBack(added, around, c, closed);
        }
    }

    /**
     * Deals the flux that a split element has gained to its vertices but the new ones, by the area of its triangles
     * around each.
     *
     * @param area  1 per triangle; not modified
     * @param added modified: three times the flux of one channel, 1 per vertex
     */
    private void addGain(int e, int channel, int[] first, Solution closed, double[] area, double[] added) {
        double before = 0;
        for (int k = 0; k < 3; k++) {
            before += irradiance(solution.corners()[3 * e + k], channel) / 3;
        }
        double gain = 0;
        double weights = 0;
        for (int i = 3 * first[e]; i < 3 * first[e + 1]; i++) {
            int v = closed.corners()[i];
            gain += area[i / 3] * (closed.irradiance()[closed.channels() * v + channel] - before);
            weights += v < solution.vertices() ? area[i / 3] : 0;
        }
        for (int i = 3 * first[e]; i < 3 * first[e + 1] && weights > 0; i++) {
            int v = closed.corners()[i];
            added[v] += v < solution.vertices() ? gain * area[i / 3] / weights : 0;
        }
    }

    /**
     * Lowers the vertices by the flux that was added to the triangles around them, and puts new vertices between.
     *
     * @param added  1 per vertex: three times the flux of one channel; not modified
     * @param around 1 per vertex: area of the triangles around it; not modified
     */
    private void takeBack(double[] added, double[] around, int channel, Solution closed) {
        double[] irradiance = closed.irradiance();
        int n = closed.channels();
        for (int v = 0; v < solution.vertices(); v++) {
            double old = irradiance[n * v + channel];
            irradiance[n * v + channel] -= added[v] == 0 ? 0 : Math.min(added[v] / around[v], Math.max(0, old));
        }
        for (int i = 0; i < created.size(); i++) {
            Created between = created.get(i);
            irradiance[n * (solution.vertices() + i) + channel] =
                    (1 - between.share) * irradiance[n * between.from + channel]
                    + between.share * irradiance[n * between.to + channel];
        }
    }

    private double[] withCreated(double[] old, int from, int count) {
        double[] all = Arrays.copyOf(old,
                ArraySize.of("light at vertices in " + count + " channels", count, old.length / count
                        + created.size()));
        for (int i = 0; i < created.size(); i++) {
            System.arraycopy(created.get(i).values, from, all, old.length + count * i, count);
        }
        return all;
    }

    /** The vertices strictly inside edge k of an element, from corner k of the element to the next corner. */
    private int[] hanging(int e, int k) {
        int[] c = solution.corners();
        int a = c[3 * e + k];
        int b = c[3 * e + (k + 1) % 3];
        if (!isOpen(a, b)) {
            return new int[0];
        }
        int opposite = same[c[3 * e + (k + 2) % 3]];
        TreeMap<Double, Integer> inside = new TreeMap<>();
        tree.near(point(a), point(b), tolerance, i -> {
            int v = ends[i];
            double t = along(a, b, v);
            if (v != same[a] && v != same[b] && v != opposite && t > 0 && t < 1) {
                inside.merge(t, v, Math::min);
            }
        });
        return inside.isEmpty() ? new int[0] : vertices(a, b, inside);
    }

    /** Position of v along the edge ab, 0 at a and 1 at b; NaN farther than the tolerance from the edge's line. */
    private double along(int a, int b, int v) {
        double dot = 0;
        double square = 0;
        double distance = 0;
        for (int i = 0; i < 3; i++) {
            double d = positions[3 * b + i] - positions[3 * a + i];
            double p = positions[3 * v + i] - positions[3 * a + i];
            dot += d * p;
            square += d * d;
            distance += p * p;
        }
        double t = dot / square;
        return distance - t * dot <= tolerance * tolerance ? t : Double.NaN;
    }

    /**
     * Vertices of the edge's part at given points of the edge ab. A vertex is created where the part has none, and at
     * all points if the part's vertices there are not those of elements across the edge.
     */
    private int[] vertices(int a, int b, TreeMap<Double, Integer> inside) {
        double[] t = inside.keySet().stream().mapToDouble(Double::doubleValue).toArray();
        int[] at = inside.values().stream().mapToInt(Integer::intValue).toArray();
        int[] found = new int[at.length];
        for (int i = 0; i < at.length; i++) {
            found[i] = vertexAt.find(key(a, at[i]));
        }
        if (!isAcross(a, found, b)) {
            Arrays.fill(found, -1);
        }
        int[] vertices = found.clone();
        for (int i = 0; i < at.length; i++) {
            if (found[i] < 0) {
                int before = i - 1;
                int after = i + 1;
                while (before >= 0 && found[before] < 0) {
                    before--;
                }
                while (after < at.length && found[after] < 0) {
                    after++;
                }
                double from = before < 0 ? 0 : t[before];
                double to = after == at.length ? 1 : t[after];
                vertices[i] = add(before < 0 ? a : found[before], after == at.length ? b : found[after],
                        (t[i] - from) / (to - from), at[i]);
                vertexAt.put(key(a, at[i]), vertices[i]);
            }
        }
        return vertices;
    }

    /**
     * Whether the part's vertices on the edge ab, -1 where it has none, belong to smaller elements across the edge:
     * open edges then lead from a over these vertices to b. Elements behind a wall that stands on the edge end in
     * vertices of their own.
     */
    private boolean isAcross(int a, int[] found, int b) {
        int last = a;
        for (int v : found) {
            if (v >= 0 && !isOpen(last, v)) {
                return false;
            }
            last = v >= 0 ? v : last;
        }
        return last == a || isOpen(last, b);
    }

    /** Creates a vertex at the position of {@code at}, its irradiance interpolated between two vertices. */
    private int add(int from, int to, double share, int at) {
        double[] vertex = Arrays.copyOf(point(at), 3 + solution.channels());
        for (int c = 0; c < solution.channels(); c++) {
            vertex[3 + c] = (1 - share) * irradiance(from, c) + share * irradiance(to, c);
        }
        created.add(new Created(from, to, share, vertex));
        return solution.vertices() + created.size() - 1;
    }

    private double irradiance(int vertex, int channel) {
        return vertex < solution.vertices() ? solution.irradiance()[vertex * solution.channels() + channel]
                : created.get(vertex - solution.vertices()).values[3 + channel];
    }

    /** An element with corners a, b, c and the hanging vertices on each edge, in the direction of the edge. */
    private record Polygon(int a, int[] ab, int b, int[] bc, int c, int[] ca) {

        Polygon turned() {
            return new Polygon(b, bc, c, ca, a, ab);
        }
    }

    /** Divides an element from the middle hanging vertex of an edge to the opposite corner, until none is left. */
    private void emit(int element, Polygon p) {
        int most = Math.max(p.ab.length, Math.max(p.bc.length, p.ca.length));
        if (most == 0) {
            triangles++;
            corners.add(p.a).add(p.b).add(p.c);
            faceOf.add(solution.faceOf()[element]);
        } else if (p.ab.length < most) {
            emit(element, p.turned());
        } else {
            int m = most / 2;
            int[] none = {};
            emit(element, new Polygon(p.a, Arrays.copyOf(p.ab, m), p.ab[m], none, p.c, p.ca));
            emit(element, new Polygon(p.ab[m], Arrays.copyOfRange(p.ab, m + 1, most), p.b, p.bc, p.c, none));
        }
    }
}
