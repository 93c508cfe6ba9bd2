package radiosity.mesh.room;

import java.util.Arrays;
import java.util.function.IntConsumer;
import radiosity.mesh.face.Faces;
import radiosity.scene.Vec3;

/**
 * Finds which faces that meet at an edge face each other: neighbours around the edge with air in between.
 *
 * <p>A face whose neighbour around the edge shows its back looks into a space that is no room.
 */
final class RadialEdges {

    /** Angles around an edge are rounded to multiples of this, in quarter turns: faces at equal angles coincide. */
    private static final double SAME = 1e-6;

    private final Faces faces;

    RadialEdges(Faces faces) {
        this.faces = faces;
    }

    /** Receives each pair of faces that face each other. */
    interface Meeting {
        void meet(int face, int other);
    }

    /** A face at an edge: its angle around the edge, and whether it looks towards larger angles. */
    private record Leaf(int face, double angle, boolean ahead) { }

    /**
     * @param some  sides at the edge from p to q: 2 * face, + 1 where the face runs from p to q; not modified
     * @param alone receives each face that looks at a back
     */
    void pair(int p, int q, int[] some, Meeting meeting, IntConsumer alone) {
        Vec3 along = faces.place(q).minus(faces.place(p)).unit();
        Vec3 zero = across(some[0] / 2, p, along);
        Leaf[] leaves = Arrays.stream(some).mapToObj(side -> new Leaf(side / 2,
                Math.rint(angle(zero, along, across(side / 2, p, along)) / SAME), side % 2 == 1)).toArray(Leaf[]::new);
        Arrays.sort(leaves, (a, b) -> a.angle != b.angle ? Double.compare(a.angle, b.angle)
                : Boolean.compare(a.ahead, b.ahead));
        for (int i = 0; i < leaves.length; i++) {
            Leaf here = leaves[i];
            Leaf next = leaves[(i + 1) % leaves.length];
            if (here.ahead && !next.ahead) {
                meeting.meet(here.face, next.face);
            } else if (here.ahead) {
                alone.accept(here.face);
            } else if (!next.ahead) {
                alone.accept(next.face);
            }
        }
    }

    /** A vector of any length from an edge into a face, at right angles to the edge. */
    private Vec3 across(int f, int p, Vec3 along) {
        Vec3 sum = Vec3.ZERO;
        for (int k = 0; k < 3; k++) {
            Vec3 d = faces.sceneCorner(f, k).minus(faces.place(p));
            sum = sum.plus(d.minus(along.times(d.dot(along))));
        }
        return sum;
    }

    /** A measure from 0 to 4 that grows with the angle from {@code zero} about the edge; 1 per quarter turn. */
    private static double angle(Vec3 zero, Vec3 along, Vec3 v) {
        double x = v.dot(zero) / (zero.length() * v.length());
        double y = v.dot(along.cross(zero)) / (zero.length() * v.length());
        if (Math.abs(y) < SAME && x > 0) {
            return 0;
        }
        return y >= 0 ? 1 - x : 3 + x;
    }
}
