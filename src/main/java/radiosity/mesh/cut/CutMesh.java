package radiosity.mesh.cut;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Predicate;
import radiosity.mesh.face.CutPoints;
import radiosity.mesh.face.Faces;
import radiosity.scene.Vec3;

/**
 * The faces of one plane as convex polygons with common edges, which are divided along contacts.
 *
 * <p>A triangle much larger than a contact on it is first divided in four, so that a short contact leaves no long
 * splinters; then contact lines divide whole polygons. A new point on an edge becomes a point of the polygons on both
 * sides of the edge.
 */
final class CutMesh {

    /** A triangle is divided in four where its longest edge is longer than this number of contact lengths. */
    private static final double COARSE = 4;

    private final Faces faces;
    private final CutPoints points;
    private final double near;
    private final int most;
    /** By face: its polygons in the order in which they were made. */
    private final Map<Integer, List<CutPolygon>> polygons = new HashMap<>();
    private int count;
    /** By the {@link #key} of a directed edge: the polygon whose loop runs along the edge in this direction. */
    private final Map<Long, CutPolygon> beside = new HashMap<>();

    /** @param most number of polygons above which no polygon is divided any more */
    CutMesh(Faces faces, CutPoints points, int most) {
        this.most = most;
        this.faces = faces;
        this.points = points;
        near = Faces.NEAR * faces.size();
    }

    void add(int face) {
        for (int k = 0; k < 3; k++) {
            points.use(faces.point[3 * face + k]);
        }
        int[] corners = {faces.point[3 * face], faces.point[3 * face + 1], faces.point[3 * face + 2]};
        add(new CutPolygon(face, corners, corners, points));
    }

    private void add(CutPolygon p) {
        polygons.computeIfAbsent(p.face, none -> new ArrayList<>(1)).add(p);
        count++;
        for (int i = 0; i < p.loop.length; i++) {
            beside.put(key(p.loop[i], p.after(i)), p);
        }
    }

    /** Key of a directed edge; the factor gives the edges of neighbouring points different hash codes. */
    private static long key(int from, int to) {
        return ((long) from << 32 | to) * 0x9e3779b97f4a7c15L;
    }

    /** The polygons of one face. */
    List<CutPolygon> polygons(int face) {
        return polygons.get(face);
    }

    /*---- Triangles in four ----*/

    void refine(int face, Contact contact) {
        each(face, p -> p.corners != null && longest(p) > COARSE * contact.length() && crossing(p, contact) != null,
                this::divide);
    }

    /** Hands the wanted polygons of a face, also those added meanwhile, to {@code todo}, until there are too many. */
    private void each(int face, Predicate<CutPolygon> wanted, Consumer<CutPolygon> todo) {
        List<CutPolygon> some = polygons.get(face);
        for (int i = 0; i < some.size() && count <= most; i++) {
            CutPolygon p = some.get(i);
            if (wanted.test(p)) {
                some.remove(i--);
                count--;
                todo.accept(p);
            }
        }
    }

    private double longest(CutPolygon p) {
        double most = 0;
        for (int k = 0; k < 3; k++) {
            most = Math.max(most, points.at(p.corners[k]).minus(points.at(p.corners[(k + 1) % 3])).length());
        }
        return most;
    }

    private void divide(CutPolygon p) {
        int[] c = p.corners;
        int[] middle = new int[3];
        for (int k = 0; k < 3; k++) {
            middle[k] = middle(p, c[k], c[(k + 1) % 3]);
        }
        for (int k = 0; k < 3; k++) {
            int before = middle[(k + 2) % 3];
            add(new CutPolygon(p.face, p.chain(before, middle[k]), new int[] {c[k], middle[k], before},
                    points));
        }
        add(new CutPolygon(p.face, middle, middle, points));
    }

    private int middle(CutPolygon p, int from, int to) {
        Vec3 place = points.middle(from, to);
        int m = points.number(place);
        if (p.place(m) < 0) {
            Vec3 start = points.at(from);
            double half = place.minus(start).length();
            int u = from;
            int v = p.after(p.place(u));
            while (points.at(v).minus(start).length() < half) {
                u = v;
                v = p.after(p.place(u));
            }
            insert(p, u, v, m);
        }
        return m;
    }

    /** Inserts a point in the edge from u to v of p and of its neighbour; {@link #beside} is not changed for p. */
    private void insert(CutPolygon p, int u, int v, int point) {
        p.insert(u, point);
        CutPolygon other = beside.get(key(v, u));
        if (other != null) {
            other.insert(v, point);
            beside.put(key(v, point), other);
            beside.put(key(point, u), other);
        }
    }

    /*---- Lines ----*/

    void cut(int face, Contact contact) {
        each(face, p -> crossing(p, contact) != null, p -> cut(p, contact));
    }

    /** Makes the ends of a contact points of the mesh where they lie on an edge, along the contact, of two polygons. */
    void pin(int face, Contact contact) {
        for (int i = 0; i < 2; i++) {
            Vec3 end = i == 0 ? contact.from() : contact.to();
            for (CutPolygon p : polygons.get(face)) {
                if (p.middle.minus(end).length() <= p.radius + near) {
                    pin(p, contact, end);
                }
            }
        }
    }

    private void pin(CutPolygon p, Contact contact, Vec3 end) {
        double at = contact.along(end);
        double b = contact.along(points.at(p.loop[0]));
        for (int i = 0; i < p.loop.length; i++) {
            int u = p.loop[i];
            int v = p.after(i);
            double a = b;
            b = contact.along(points.at(v));
            if (at > Math.min(a, b) + near && at < Math.max(a, b) - near && beside(contact, u) == 0
                    && beside(contact, v) == 0 && beside.containsKey(key(v, u))) {
                int point = points.number(end);
                insert(p, u, v, point);
                beside.put(key(u, point), p);
                beside.put(key(point, v), p);
                return;
            }
        }
    }

    private void cut(CutPolygon p, Contact contact) {
        int[] at = crossing(p, contact);
        int[] u = {p.loop[at[0]], p.loop[at[1]]};
        int[] v = {p.after(at[0]), p.after(at[1])};
        int[] end = new int[2];
        for (int i = 0; i < 2; i++) {
            double d = beside(contact, u[i]);
            end[i] = d == 0 ? u[i] : meeting(contact, Math.min(u[i], v[i]), Math.max(u[i], v[i]));
            if (d != 0) {
                insert(p, u[i], v[i], end[i]);
            }
        }
        add(new CutPolygon(p.face, p.chain(end[0], end[1]), null, points));
        add(new CutPolygon(p.face, p.chain(end[1], end[0]), null, points));
    }

    /** The point at which a contact's line meets an edge; u must be below v, so that both sides get the same point. */
    private int meeting(Contact contact, int u, int v) {
        double du = beside(contact, u);
        double dv = beside(contact, v);
        Vec3 start = points.at(u);
        Vec3 place = start.plus(points.at(v).minus(start).times(du / (du - dv)));
        return points.number(place);
    }

    private double beside(Contact contact, int point) {
        double d = contact.beside(points.at(point));
        return Math.abs(d) <= near ? 0 : d;
    }

    /**
     * The two indices in a polygon's loop at which, or between which and the next, a contact's line passes; null where
     * the contact itself does not pass through the inside of the polygon.
     */
    private int[] crossing(CutPolygon p, Contact contact) {
        if (!contact.reaches(p.middle, p.radius + near)) {
            return null;
        }
        int n = p.loop.length;
        double[] d = new double[n];
        double low = 0;
        double high = 0;
        for (int i = 0; i < n; i++) {
            d[i] = beside(contact, p.loop[i]);
            low = Math.min(low, d[i]);
            high = Math.max(high, d[i]);
        }
        if (low == 0 || high == 0) {
            return null;
        }
        int[] at = new int[2];
        double[] place = new double[2];
        int found = 0;
        for (int i = 0; i < n && found < 2; i++) {
            double next = d[(i + 1) % n];
            if (d[i] == 0 || d[i] * next < 0) {
                double here = contact.along(points.at(p.loop[i]));
                double there = contact.along(points.at(p.after(i)));
                place[found] = d[i] == 0 ? here : here + (there - here) * d[i] / (d[i] - next);
                at[found++] = i;
            }
        }
        double from = Math.max(0, Math.min(place[0], place[1]));
        double to = Math.min(contact.length(), Math.max(place[0], place[1]));
        return found == 2 && to - from > near ? at : null;
    }
}
