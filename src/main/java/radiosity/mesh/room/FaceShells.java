package radiosity.mesh.room;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import radiosity.mesh.face.EdgePieces;
import radiosity.mesh.face.Faces;
import radiosity.util.DisjointSets;
import radiosity.util.EdgeKey;
import radiosity.util.LongIndex;

/**
 * Shells: sets of faces that are connected across edges and border on the same air, as neighbours face each other.
 *
 * <p>A shell is whole where every face has, across every edge, a face of the same shell that faces it; corners of other
 * faces may stand on an edge.
 */
final class FaceShells {

    private final Faces faces;
    /** 1 per face: the lowest face of its shell. */
    final int[] shell;
    /** 1 per lowest face: whether the shell is not whole. */
    final boolean[] open;
    /** 1 per lowest face: whether a face of the shell looks at the back of another face across an edge. */
    final boolean[] seesBacks;
    /** 1 per lowest face: volume of the shell, in cubed scene sizes; negative where the shell is seen from inside. */
    final double[] volume;
    /** 6 per lowest face: box around the shell, low x, y, z, high x, y, z. */
    final double[] box;
    /** Per lowest face of an open shell: the two ends of each edge that belongs to one face only. */
    final Map<Integer, List<int[]>> rims = new HashMap<>();

    /** 2 per edge or piece: ends, lower first. The sides at an edge are a list from {@code first} by {@code next}. */
    private int[] ends;
    private int[] first;
    private int[] next;
    /** 1 per side: 2 * face, + 1 where the face runs along the edge from the lower end to the higher. */
    private int[] side;
    private int sides;
    private LongIndex edges;

    FaceShells(Faces faces) {
        this.faces = faces;
        int n = faces.count();
        shell = new int[n];
        open = new boolean[n];
        seesBacks = new boolean[n];
        volume = new double[n];
        box = new double[6 * n];
        begin(3 * n);
        for (int e = 0; e < 3 * n; e++) {
            put(faces.point[e], faces.point[3 * (e / 3) + (e + 1) % 3], e / 3);
        }
        divideLoose();
        join();
        measure();
    }

    private void measure() {
        for (int f = 0; f < shell.length; f++) {
            int s = shell[f];
            if (s == f) {
                Arrays.fill(box, 6 * s, 6 * s + 3, Double.POSITIVE_INFINITY);
                Arrays.fill(box, 6 * s + 3, 6 * s + 6, Double.NEGATIVE_INFINITY);
            }
            for (int i = 0; i < 9; i++) {
                float x = faces.corner[9 * f + i];
                box[6 * s + i % 3] = Math.min(box[6 * s + i % 3], x);
                box[6 * s + 3 + i % 3] = Math.max(box[6 * s + 3 + i % 3], x);
            }
            volume[s] += SolidAngle.volume(faces, f);
        }
    }

    /** Whether no face is missing from a shell: none has an edge of its own or looks at the back of another face. */
    boolean isWhole(int s) {
        return !open[s] && !seesBacks[s];
    }

    private void begin(int expected) {
        edges = new LongIndex(expected);
        first = new int[expected];
        ends = new int[2 * expected];
        next = new int[expected];
        side = new int[expected];
        sides = 0;
        Arrays.fill(first, -1);
    }

    /** Adds an edge of a face, or a piece of one, in the direction in which the face runs along it. */
    private void put(int p, int q, int face) {
        int known = edges.size();
        int edge = edges.findOrAdd(EdgeKey.of(p, q), known);
        if (sides == side.length) {
            side = Arrays.copyOf(side, 2 * sides);
            next = Arrays.copyOf(next, 2 * sides);
        }
        if (edge == first.length) {
            first = Arrays.copyOf(first, 2 * edge);
            Arrays.fill(first, edge, 2 * edge, -1);
            ends = Arrays.copyOf(ends, 4 * edge);
        }
        ends[2 * edge] = Math.min(p, q);
        ends[2 * edge + 1] = Math.max(p, q);
        side[sides] = 2 * face + (p < q ? 1 : 0);
        next[sides] = first[edge];
        first[edge] = sides++;
    }

    private boolean isLoose(int edge) {
        return next[first[edge]] < 0;
    }

    /** Whether the first two faces at an edge have opposite normals, as the two sides of one sheet have. */
    private boolean isTwoSided(int edge) {
        int f = side[first[edge]] / 2;
        int g = isLoose(edge) ? f : side[next[first[edge]]] / 2;
        double cosine = 0;
        for (int a = 0; a < 3; a++) {
            cosine += faces.normal(f, a) * faces.normal(g, a);
        }
        return cosine < -1 + 1e-6;
    }

    /** Divides edges of one face only, or of the two sides of one sheet, where ends of other edges stand on them. */
    private void divideLoose() {
        int[] loose = IntStream.range(0, edges.size()).filter(edge -> isLoose(edge) || isTwoSided(edge)).toArray();
        int[] others = IntStream.concat(Arrays.stream(loose), IntStream.range(0, edges.size()).filter(this::isContact))
                .toArray();
        int[] points = Arrays.stream(others).flatMap(e -> IntStream.of(ends[2 * e], ends[2 * e + 1])).distinct()
                .toArray();
        EdgePieces pieces = new EdgePieces(faces, points, loose.length);
        int[] allEnds = ends;
        int[] allFirst = first;
        int[] allNext = next;
        int[] allSides = side;
        int count = edges.size();
        boolean[] divide = new boolean[count];
        for (int edge : loose) {
            divide[edge] = true;
        }
        begin(sides);
        for (int e = 0; e < count; e++) {
            int[] stops = divide[e] ? pieces.stops(allEnds[2 * e], allEnds[2 * e + 1])
                    : new int[] {allEnds[2 * e], allEnds[2 * e + 1]};
            for (int s = allFirst[e]; s >= 0; s = allNext[s]) {
                for (int i = 0; i + 1 < stops.length; i++) {
                    boolean up = allSides[s] % 2 == 1;
                    put(up ? stops[i] : stops[i + 1], up ? stops[i + 1] : stops[i], allSides[s] / 2);
                }
            }
        }
    }

    /** Whether all faces at an edge are pieces and end at a border of their coplanar region there. */
    private boolean isContact(int edge) {
        for (int s = first[edge]; s >= 0; s = next[s]) {
            int f = side[s] / 2;
            int k = 0;
            while (faces.point[3 * f + k] == ends[2 * edge] || faces.point[3 * f + k] == ends[2 * edge + 1]) {
                k++;
            }
            if (!faces.isPiece(f) || !faces.isBorder(f, k)) {
                return false;
            }
        }
        return true;
    }

    private void join() {
        RadialEdges wedges = new RadialEdges(faces);
        DisjointSets joined = new DisjointSets(shell.length);
        boolean[] alone = new boolean[shell.length];
        for (int edge = 0; edge < edges.size(); edge++) {
            if (!isLoose(edge)) {
                wedges.pair(ends[2 * edge], ends[2 * edge + 1], sides(edge), joined::join, f -> alone[f] = true);
            }
        }
        for (int f = 0; f < shell.length; f++) {
            shell[f] = joined.of(f);
            seesBacks[shell[f]] |= alone[f];
            open[shell[f]] |= alone[f];
        }
        for (int edge = 0; edge < edges.size(); edge++) {
            if (isLoose(edge)) {
                int s = shell[side[first[edge]] / 2];
                open[s] = true;
                rims.computeIfAbsent(s, none -> new ArrayList<>()).add(new int[] {ends[2 * edge], ends[2 * edge + 1]});
            }
        }
    }

    private int[] sides(int edge) {
        IntStream.Builder some = IntStream.builder();
        for (int s = first[edge]; s >= 0; s = next[s]) {
            some.add(side[s]);
        }
        return some.build().toArray();
    }
}
