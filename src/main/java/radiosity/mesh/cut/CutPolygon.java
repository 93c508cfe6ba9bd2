package radiosity.mesh.cut;

import java.util.Arrays;
import radiosity.mesh.face.CutPoints;
import radiosity.scene.Vec3;

/** A convex piece of a face. Neighbouring polygons may have corners on its edges. */
final class CutPolygon {

    final int face;
    /** Points, counter-clockwise, including the corners of neighbouring polygons that lie on its edges. */
    int[] loop;
    /** The three corners where the polygon is still a triangle; else null. */
    final int[] corners;
    /** Middle and radius of a sphere around the polygon, scene units. */
    final Vec3 middle;
    final double radius;

    CutPolygon(int face, int[] loop, int[] corners, CutPoints points) {
        this.face = face;
        this.loop = loop;
        this.corners = corners;
        middle = Arrays.stream(loop).mapToObj(points::at).reduce(Vec3.ZERO, Vec3::plus).times(1.0 / loop.length);
        radius = Arrays.stream(loop).mapToDouble(p -> points.at(p).minus(middle).length()).max().orElseThrow();
    }

    int place(int point) {
        for (int i = 0; i < loop.length; i++) {
            if (loop[i] == point) {
                return i;
            }
        }
        return -1;
    }

    int after(int i) {
        return loop[(i + 1) % loop.length];
    }

    /** The points of the loop from one to another, both included. */
    int[] chain(int from, int to) {
        int start = place(from);
        int count = Math.floorMod(place(to) - start, loop.length) + 1;
        int[] chain = new int[count];
        Arrays.setAll(chain, i -> loop[(start + i) % loop.length]);
        return chain;
    }

    /** Inserts a point in the loop behind another point. */
    void insert(int after, int point) {
        int at = place(after) + 1;
        int[] longer = new int[loop.length + 1];
        System.arraycopy(loop, 0, longer, 0, at);
        longer[at] = point;
        System.arraycopy(loop, at, longer, at + 1, loop.length - at);
        loop = longer;
    }
}
