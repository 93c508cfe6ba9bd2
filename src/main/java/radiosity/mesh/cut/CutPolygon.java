package radiosity.mesh.cut;

import java.util.Arrays;

/** A convex piece of a face. Neighbouring polygons may have corners on its edges. */
final class CutPolygon {

    final int face;
    /** Points, counter-clockwise, including the corners of neighbouring polygons that lie on its edges. */
    int[] loop;
    /** The three corners where the polygon is still a triangle; else null. */
    final int[] corners;

    CutPolygon(int face, int[] loop, int[] corners) {
        this.face = face;
        this.loop = loop;
        this.corners = corners;
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
