package radiosity.mesh.cut;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import radiosity.mesh.face.CutPoints;
import radiosity.mesh.face.FacePieces;
import radiosity.mesh.face.Faces;
import radiosity.scene.Vec3;
import radiosity.util.EdgeKey;
import radiosity.util.LongIndex;

/**
 * Cuts large faces where other triangles stand on them or pass through them, so that no element has the light of both
 * sides of a wall, or lies half under a block.
 *
 * <p>This is discontinuity meshing for discontinuities at which refinement would never end: D. Baum, S. Mann, K. Smith,
 * J. Winget, Making radiosity usable, 1991. Coplanar regions of small faces only are left as they are.
 */
public final class DiscontinuityMesher {

    /** A coplanar region is cut if one of its faces is larger than this share of the area of all faces. */
    public static final double LEAST_AREA = 2e-4;
    /** Points nearer to each other than this are one point, in scene sizes. */
    private static final double SAME = 1e-7;
    /** Most pieces of all faces: more pieces would replace the mesh instead of preparing it. */
    private static final int MOST = 20_000;
    /** Most pieces where gaps are cut in bands, too. */
    private static final int MOST_WITH_GAPS = 30_000;
    /** Least length of a contact that is worth an edge, relative to the square root of the area of all faces. */
    private static final double LEAST_LENGTH = 1e-3;
    /**
     * Length of a contact inside of a face, and its distance from the border of the face's region, up to which it is
     * not worth a cut, relative to the square root of the area of all faces: where a mesh is not welded, triangles from
     * beyond the border pass through its faces by that little.
     */
    private static final double TRIFLE = LEAST_LENGTH / 5;

    private final Faces faces;
    final FaceIntersections contacts;
    private final EdgeBands bands;
    private final GapBands gaps;
    /** Length of the shortest contact or band that counts, scene units. */
    private final double leastLength;
    private final CutPoints points;
    /** Per face that is cut: 3 points per piece. */
    private final Map<Integer, List<int[]>> pieces = new HashMap<>();
    /** Edges of pieces along contacts, see {@link EdgeKey}. */
    final LongIndex edges = new LongIndex(0);
    private int count;
    private final int most;

    /**
     * Cuts large faces along their contacts. Where the contacts would make too many pieces, the least length of a
     * contact is doubled until they do not: the edge of a window pane in its wall stays, the feet of chairs are left
     * out. Gaps are cut in bands as far as there is room for more pieces, the longest first.
     *
     * @return the faces themselves where nothing stands on them or passes through
     */
    public static Faces cut(Faces faces) {
        double least = LEAST_LENGTH;
        EdgeBands bands = new EdgeBands(faces, least * unit(faces));
        GapBands gaps = new GapBands(faces, least * unit(faces));
        DiscontinuityMesher mesher = new DiscontinuityMesher(faces, least, bands, gaps.longest(0));
        while (mesher.isTooFine()) {
            least *= 2;
            mesher = new DiscontinuityMesher(faces, least, bands, gaps.longest(0));
        }
        DiscontinuityMesher best = mesher;
        for (int mouths = gaps.mouths(); mouths > 0 && best == mesher; mouths /= 2) {
            DiscontinuityMesher finer = new DiscontinuityMesher(faces, least, bands, gaps.longest(mouths));
            best = finer.isTooFine() ? mesher : finer;
        }
        return best.pieces.isEmpty() ? faces
                : faces.withPieces(new FacePieces(best.points, best.pieces, best.edges));
    }

    DiscontinuityMesher(Faces faces) {
        this(faces, LEAST_LENGTH, new EdgeBands(faces, LEAST_LENGTH * unit(faces)),
                new GapBands(faces, LEAST_LENGTH * unit(faces)));
    }

    /** Square root of the area of all faces, scene units. */
    private static double unit(Faces faces) {
        return Math.sqrt(faces.area()) * faces.size();
    }

    /**
     * @param least length of the shortest contact or band that counts, relative to the square root of the area of all
     *              faces
     */
    private DiscontinuityMesher(Faces faces, double least, EdgeBands bands, GapBands gaps) {
        this.faces = faces;
        this.bands = bands;
        this.gaps = gaps;
        most = gaps.mouths() > 0 ? MOST_WITH_GAPS : MOST;
        points = new CutPoints(faces.scene(), SAME * faces.size());
        leastLength = least * unit(faces);
        contacts = new FaceIntersections(faces, points, leastLength);
        for (List<Integer> part : parts().values()) {
            if (!isTooFine()) {
                cut(part);
            }
        }
    }

    /** Whether cutting was given up, as there would be too many pieces. */
    private boolean isTooFine() {
        return count > most;
    }

    private Map<Integer, List<Integer>> parts() {
        Map<Integer, List<Integer>> parts = new TreeMap<>();
        double least = LEAST_AREA * faces.area();
        Set<Integer> large = new HashSet<>();
        for (int f = 0; f < faces.count(); f++) {
            if (faces.area(f) > least) {
                large.add(faces.part[f]);
            }
        }
        for (int f = 0; f < faces.count(); f++) {
            if (large.contains(faces.part[f])) {
                parts.computeIfAbsent(faces.part[f], none -> new ArrayList<>()).add(f);
            }
        }
        return parts;
    }

    private void cut(List<Integer> part) {
        Map<Integer, List<Contact>> on = new TreeMap<>();
        CutMesh mesh = new CutMesh(faces, points, most);
        contacts.begin(part);
        bands.begin(part);
        for (int f : part) {
            on.put(f, contacts.on(f));
            mesh.add(f);
        }
        on.forEach((f, some) -> worthACut(f, some).forEach(contact -> mesh.refine(f, contact)));
        on.forEach((f, some) -> worthACut(f, some).forEach(contact -> mesh.cut(f, contact)));
        part.forEach(f -> worthACut(f, bands.on(f, leastLength)).forEach(line -> mesh.cut(f, line)));
        part.forEach(f -> worthACut(f, gaps.on(f)).forEach(line -> mesh.cut(f, line)));
        int divided = part.stream().mapToInt(f -> mesh.polygons(f).size()).filter(n -> n > 1).sum();
        if (count + divided > most) {
            count += divided;
            return;
        }
        on.forEach((f, some) -> some.forEach(contact -> mesh.pin(f, contact)));
        for (int f : part) {
            for (CutPolygon polygon : mesh.polygons(f)) {
                take(polygon);
                mark(polygon, on.get(f));
            }
        }
        part.forEach(this::leaveWhole);
        count += part.stream().filter(pieces::containsKey).mapToInt(f -> pieces.get(f).size()).sum();
    }

    private Stream<Contact> worthACut(int face, List<Contact> contacts) {
        return contacts.stream().filter(contact -> isWorthACut(face, contact));
    }

    /** Whether the part of a contact inside of a face is long enough, and far enough from borders of the region. */
    private boolean isWorthACut(int face, Contact contact) {
        double trifle = TRIFLE * unit(faces);
        Vec3[] corner = {faces.sceneCorner(face, 0), faces.sceneCorner(face, 1), faces.sceneCorner(face, 2)};
        Optional<Contact> inside = contact.within(corner[0], corner[1], corner[2]);
        boolean isWorth = inside.isPresent() && inside.get().length() > trifle;
        for (int k = 0; k < 3 && isWorth; k++) {
            Vec3 from = corner[(k + 1) % 3];
            Vec3 inwards = faces.exactNormal(face).cross(corner[(k + 2) % 3].minus(from)).unit();
            double depth = Math.max(inside.get().from().minus(from).dot(inwards),
                    inside.get().to().minus(from).dot(inwards));
            isWorth = !faces.isBorder(face, k) || depth > trifle;
        }
        return isWorth;
    }

    private void take(CutPolygon polygon) {
        pieces.computeIfAbsent(polygon.face, none -> new ArrayList<>())
                .addAll(new ConvexTriangulator(points, faces.exactNormal(polygon.face)).triangles(polygon.loop));
    }

    /** Keeps a face that is not cut, or too thin for a triangle of its pieces. */
    private void leaveWhole(int face) {
        if (pieces.get(face).size() <= 1) {
            pieces.remove(face);
        }
    }

    private void mark(CutPolygon polygon, List<Contact> contacts) {
        double near = Faces.NEAR * faces.size();
        List<Contact> beside = contacts.stream()
                .filter(contact -> contact.reaches(polygon.middle, polygon.radius + 2 * near)).toList();
        for (int i = 0; i < polygon.loop.length; i++) {
            int p = polygon.loop[i];
            int q = polygon.after(i);
            Vec3 a = points.at(p);
            Vec3 b = points.at(q);
            if (beside.stream().anyMatch(contact -> contact.reaches(a, 2 * near) && contact.reaches(b, 2 * near))) {
                edges.findOrAdd(EdgeKey.of(p, q), edges.size());
            }
        }
    }
}
