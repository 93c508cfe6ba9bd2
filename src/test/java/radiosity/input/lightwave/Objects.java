package radiosity.input.lightwave;

import static radiosity.input.lightwave.Iff.chunk;
import static radiosity.input.lightwave.Iff.f4;
import static radiosity.input.lightwave.Iff.form;
import static radiosity.input.lightwave.Iff.join;
import static radiosity.input.lightwave.Iff.s0;
import static radiosity.input.lightwave.Iff.sub;
import static radiosity.input.lightwave.Iff.text;
import static radiosity.input.lightwave.Iff.u1;
import static radiosity.input.lightwave.Iff.u2;
import static radiosity.input.lightwave.Iff.u4;

/** Small objects and their parts, for tests. */
final class Objects {

    /** The right angle of a triangle of area 1/2, clockwise from -z; a fourth point makes it a square. */
    static final double[] CORNERS = {0, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0};

    private Objects() {
    }

    /** An LWOB object of points and polygons (each: count, corners, surface from 1), with one surface "white". */
    static byte[] lwob(double[] points, int... polygons) {
        return form("LWOB", chunk("PNTS", f4(points)), chunk("SRFS", s0("white")), chunk("POLS", u2(polygons)),
                white());
    }

    static byte[] triangle() {
        return lwob(CORNERS, 3, 0, 1, 2, 1);
    }

    static byte[] square() {
        return lwob(CORNERS, 4, 0, 1, 2, 3, 1);
    }

    static byte[] white() {
        return chunk("SURF", s0("white"), sub("COLR", u1(255, 255, 255, 0)), sub("DIFF", u2(128)));
    }

    /** An LWOB object of one polygon. */
    static byte[] polygon(double... points) {
        int n = points.length / 3;
        int[] polygon = new int[n + 2];
        polygon[0] = n;
        for (int i = 0; i < n; i++) {
            polygon[i + 1] = i;
        }
        polygon[n + 1] = 1;
        return lwob(points, polygon);
    }

    /** An LWO2 object of a square with further chunks after its own; its one tag is "white". */
    static byte[] lwo2(byte[]... more) {
        return form("LWO2", chunk("TAGS", s0("white")), layer(0, 0), squareOf("FACE"), join(more));
    }

    static byte[] layer(int number, int flags) {
        return chunk("LAYR", u2(number, flags), f4(0, 0, 0), s0(""));
    }

    /** Points and polygon of the square, its polygon tagged with the first tag. */
    static byte[] squareOf(String type) {
        return join(chunk("PNTS", f4(CORNERS)), chunk("POLS", text(type), u2(4, 0, 1, 2, 3)),
                chunk("PTAG", text("SURF"), u2(0, 0)));
    }

    static byte[] lwo2Surface(String name, String source, byte[]... parts) {
        return chunk("SURF", s0(name), s0(source), join(parts));
    }

    static byte[] colour(double r, double g, double b) {
        return sub("COLR", f4(r, g, b), u2(0));
    }

    static byte[] share(String id, double value) {
        return sub(id, f4(value), u2(0));
    }

    /** A chunk whose size is a lie. */
    static byte[] lyingChunk(String id, long size, byte[]... parts) {
        return join(text(id), u4(size), join(parts));
    }
}
