package radiosity.input.lightwave;

import static radiosity.input.lightwave.HostileCase.ERROR;
import static radiosity.input.lightwave.HostileCase.object;
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
import static radiosity.input.lightwave.Objects.CORNERS;
import static radiosity.input.lightwave.Objects.colour;
import static radiosity.input.lightwave.Objects.layer;
import static radiosity.input.lightwave.Objects.lwo2;
import static radiosity.input.lightwave.Objects.lwo2Surface;
import static radiosity.input.lightwave.Objects.lwob;
import static radiosity.input.lightwave.Objects.lyingChunk;
import static radiosity.input.lightwave.Objects.share;
import static radiosity.input.lightwave.Objects.squareOf;
import static radiosity.input.lightwave.Objects.triangle;
import static radiosity.input.lightwave.Objects.white;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;

/** Objects that are broken, or made to break readers. */
final class HostileObjects {

    private HostileObjects() {
    }

    static List<HostileCase> containers() {
        byte[] sound = triangle();
        return List.of(
                object("empty file", new byte[0], ERROR, "an empty file"),
                object("not IFF", text("hello, world"), ERROR, "hello"),
                object("Git LFS pointer", text("version https://git-lfs.github.com/spec/v1\noid sha256:0\n"), ERROR,
                        "Git LFS"),
                object("AppleDouble", join(u1(0, 5, 0x16, 7), new byte[90]), ERROR, "AppleDouble"),
                object("spoilt by UTF-8", join(text("FORM"), u1(0xEF, 0xBF, 0xBD, 0, 0xEF, 0xBF, 0xBD), text("LWOB")),
                        ERROR, "encoding"),
                object("IFF of another type", form("ILBM", new byte[8]), ERROR, "ILBM"),
                object("FORM size 0", withSize(sound, 0), 1, "size of the file"),
                object("FORM size short", withSize(sound, 20), 1, "size of the file"),
                object("FORM size 0xFFFFFFFF", withSize(sound, 0xFFFFFFFFL), 1, "size of the file"),
                object("chunk size overflow", form("LWOB", chunk("PNTS", f4(CORNERS)),
                        lyingChunk("POLS", 0x7FFFFFFF, u2(3, 0, 1, 2, 1))), 1, "longer than what holds it"),
                object("chunk size negative", form("LWOB", chunk("PNTS", f4(CORNERS)),
                        lyingChunk("POLS", 0xFFFFFFFFL, u2(3, 0, 1, 2, 1))), 1, "longer than what holds it"),
                object("pad byte missing", form("LWOB", lyingChunk("TEXT", 3, text("abc")),
                        chunk("PNTS", f4(CORNERS)), chunk("POLS", u2(3, 0, 1, 2, 1)), white()), 1, "pad byte"),
                object("a million empty chunks", join(sound, emptyChunks(1_000_000)), 1, "size of the file"),
                object("all chunks of size 0", empty("LWO2", 1), ERROR, "at least one polygon"),
                beside("all chunks of size 0 beside an object, LWOB", empty("LWOB", 1), "patches"),
                beside("all chunks of size 0 beside an object, LWO2", empty("LWO2", 1), "pivot"),
                beside("all chunks of size 0 beside an object, LWO3", empty("LWO3", 1), "pivot"),
                beside("100,000 chunks of size 0 of each kind, LWOB", empty("LWOB", 100_000), "beyond 65536"),
                beside("100,000 chunks of size 0 of each kind, LWO2", empty("LWO2", 100_000), "beyond 65536"),
                beside("object without chunks beside an object", form("LWO2"), ""),
                beside("FORM of 8 bytes beside an object", chunk("FORM"), "not found"),
                emptyLayer("layer 1 of an object without chunks", form("LWO2")),
                emptyLayer("layer 1 of an object of chunks of size 0", form("LWO2", chunk("TAGS"), chunk("SURF"))),
                object("100,000 nested forms", nestedForms(100_000), ERROR, "at least one polygon"),
                object("random names after the data", join(sound, u1(1, 2, 3, 4, 5, 6, 7, 8, 9)), 1, "no chunk"));
    }

    private static byte[] withSize(byte[] object, long size) {
        byte[] changed = object.clone();
        System.arraycopy(u4(size), 0, changed, 4, 4);
        return changed;
    }

    /** An object in a scene beside a square, of which the square's two triangles are left. */
    private static HostileCase beside(String name, byte[] object, String says) {
        return new HostileCase(name, Map.of("room.lwo", Objects.square(), "thing.lwo", object, "a.lws",
                text("LWSC\n1\n\nLoadObject thing.lwo\nLoadObject room.lwo\n")), "a.lws", 2, says);
    }

    /** The same where the scene names a layer, as those of LightWave 6 and later do; there is nothing to be said. */
    private static HostileCase emptyLayer(String name, byte[] object) {
        return new HostileCase(name, Map.of("room.lwo", Objects.square(), "thing.lwo", object, "a.lws",
                text("LWSC\n3\n\nLoadObjectLayer 1 thing.lwo\nLoadObjectLayer 1 room.lwo\n")), "a.lws", 2, "");
    }

    /** An object of n chunks without content of every name that the readers know. */
    private static byte[] empty(String type, int n) {
        List<String> names = type.equals("LWOB") ? List.of("PNTS", "SRFS", "POLS", "PCHS", "SURF", "LAYR")
                : List.of("TAGS", "LAYR", "PNTS", "POLS", "PTAG", "VMAP", "VMAD", "CLIP", "SURF", "FORM");
        return form(type, names.stream().flatMap(id -> Collections.nCopies(n, chunk(id)).stream())
                .toArray(byte[][]::new));
    }

    private static byte[] emptyChunks(int n) {
        byte[] all = new byte[8 * n];
        byte[] one = chunk("XXXX");
        for (int i = 0; i < n; i++) {
            System.arraycopy(one, 0, all, 8 * i, 8);
        }
        return all;
    }

    private static byte[] nestedForms(int depth) {
        byte[] all = new byte[12 * depth];
        for (int i = 0; i < depth; i++) {
            System.arraycopy(join(text("FORM"), u4(all.length - 12L * i - 8), text(i == 0 ? "LWO3" : "SURF")), 0, all,
                    12 * i, 12);
        }
        return all;
    }

    static List<HostileCase> points() {
        return List.of(
                object("points not a multiple of 12", form("LWOB", chunk("PNTS", f4(CORNERS), u2(1)),
                        chunk("POLS", u2(3, 0, 1, 2, 1)), white()), 1, "12 bytes"),
                object("NaN", lwob(with(4, Double.NaN), 3, 0, 1, 2, 1, 3, 0, 2, 3, 1), 1, "no finite numbers"),
                object("infinity", lwob(with(4, Double.POSITIVE_INFINITY), 3, 0, 1, 2, 1, 3, 0, 2, 3, 1), 1,
                        "no finite numbers"),
                object("3e38", lwob(scaled(3e38), 3, 0, 1, 2, 1), 1, ""),
                object("3e38 against 1", lwob(with(4, 3e38), 3, 0, 1, 2, 1, 3, 0, 2, 3, 1), 1, "without area"),
                object("denormals", lwob(scaled(1e-42), 3, 0, 1, 2, 1), 1, "as coarse as"),
                object("40,000 points", manyPoints("LWOB", 40_000), 1, ""),
                object("70,000 points", manyPoints("LWO2", 70_000), 1, ""));
    }

    private static double[] with(int i, double value) {
        double[] points = CORNERS.clone();
        points[i] = value;
        return points;
    }

    private static double[] scaled(double factor) {
        return Arrays.stream(CORNERS).map(x -> x * factor).toArray();
    }

    /** A triangle of the last three of many points. */
    private static byte[] manyPoints(String type, int n) {
        byte[] points = chunk("PNTS", new byte[12 * (n - 4)], f4(CORNERS));
        if (type.equals("LWOB")) {
            return form(type, points, chunk("POLS", u2(3, n - 3, n - 2, n - 1, 1)), chunk("SRFS", s0("white")),
                    white());
        }
        long big = 0xFF000000L;
        return form(type, chunk("TAGS", s0("white")), points, chunk("POLS", text("FACE"), u2(3),
                u4(big + n - 3, big + n - 2, big + n - 1)), chunk("PTAG", text("SURF"), u2(0, 0)),
                lwo2Surface("white", ""));
    }

    static List<HostileCase> indices() {
        return List.of(
                object("index out of range", lwob(CORNERS, 3, 0, 1, 9, 1, 3, 0, 1, 2, 1), 1,
                        "points that do not exist"),
                object("index 65535", lwob(CORNERS, 3, 0, 1, 65535, 1, 3, 0, 1, 2, 1), 1, "points that do not exist"),
                object("cut VX", form("LWO2", chunk("PNTS", f4(CORNERS)),
                        chunk("POLS", text("FACE"), u2(3, 0, 1, 2, 3, 0), u1(0xFF, 0))), 1, "cut short"),
                object("surface 0", lwob(CORNERS, 3, 0, 1, 2, 0), 1, "does not describe"),
                object("surface 32767", lwob(CORNERS, 3, 0, 1, 2, 32767), 1, "beyond the list"),
                object("surface -32768", lwob(CORNERS, 3, 0, 1, 2, -32768, 0), 1, "beyond the list"),
                object("detail polygons", lwob(CORNERS, 3, 0, 1, 2, -1, 1, 3, 0, 2, 3, 1, 3, 1, 3, 2, 1), 3, ""),
                object("a million detail polygons", lwob(CORNERS, 3, 0, 1, 2, -1, 65535, 3, 0, 2, 3, 1), 2, ""),
                object("PTAG out of range", lwo2(white2(), chunk("PTAG", text("SURF"), u2(7, 0))), 2,
                        "a polygon that does not exist"),
                object("PTAG with a tag out of range", lwo2(white2(), chunk("PTAG", text("SURF"), u2(0, 7))), 2,
                        "beyond the list"),
                object("PTAG with two POLS", lwo2(white2(), chunk("POLS", text("FACE"), u2(3, 0, 2, 1)),
                        chunk("PTAG", text("SURF"), u2(0, 0))), 3, ""),
                object("flag bits in counts", form("LWO2", chunk("TAGS", s0("white")), chunk("PNTS", f4(CORNERS)),
                        chunk("POLS", text("FACE"), u2(0xFC00 | 3, 0, 1, 2)), chunk("PTAG", text("SURF"), u2(0, 0)),
                        white2()), 1, ""),
                object("polygon cut short", lwob(CORNERS, 3, 0, 1, 2, 1, 60000, 1, 2), 1, "cut short"),
                object("polygons before points", form("LWOB", chunk("POLS", u2(3, 0, 1, 2, 1)),
                        chunk("PNTS", f4(CORNERS)), chunk("SRFS", s0("white")), white()), 1, ""));
    }

    private static byte[] white2() {
        return lwo2Surface("white", "", colour(1, 1, 1), share("DIFF", 0.5));
    }

    static List<HostileCase> surfaces() {
        String control = "\u001b[31m\u0007\r\n";
        return List.of(
                object("surface missing", lwo2(), 2, "does not describe"),
                object("surface twice", lwo2(white2(), white2()), 2, "described twice"),
                object("inheritance cycle", lwo2(lwo2Surface("white", "b"), lwo2Surface("b", "c"),
                        lwo2Surface("c", "white")), 2, "in a circle"),
                object("inherits from itself", lwo2(lwo2Surface("white", "white")), 2, "in a circle"),
                object("reflectance 5", lwo2(lwo2Surface("white", "", colour(1, 1, 1), share("DIFF", 5))), 2, "0.9999"),
                object("luminosity -3", lwo2(lwo2Surface("white", "", colour(1, .5, 1), share("LUMI", -3),
                        share("DIFF", .5))), 2, ""),
                object("NaN colour", lwo2(lwo2Surface("white", "", colour(Double.NaN, .5, 1), share("DIFF", .5))), 2,
                        ""),
                object("infinite luminosity", lwo2(lwo2Surface("white", "", share("LUMI", Double.POSITIVE_INFINITY),
                        share("DIFF", .5))), 2, ""),
                object("SPEC of 4 bytes", form("LWOB", chunk("PNTS", f4(CORNERS)), chunk("SRFS", s0("white")),
                        chunk("POLS", u2(3, 0, 1, 2, 1)), chunk("SURF", s0("white"), sub("SPEC", u4(128)),
                                sub("COLR", u1(9, 9, 9, 0)))), 1, "are specular"),
                object("values cut short", lwo2(lwo2Surface("white", "", sub("DIFF", u1(1)), sub("COLR", u2(1)))), 2,
                        "cut short"),
                object("control characters in a name", form("LWO2", chunk("TAGS", s0(control)), squareOf("FACE")), 2,
                        "\\u001b[31m"),
                object("name of 1 MB", form("LWO2", chunk("TAGS", s0("n".repeat(1 << 20))), squareOf("FACE")), 2,
                        "does not describe"),
                object("textures cut short", lwo2(lwo2Surface("white", "", share("DIFF", .5), sub("BLOK",
                        sub("IMAP", s0("a"), sub("CHAN", text("CO"))), sub("TMAP", sub("CNTR", u1(1)))))), 2, ""),
                object("layers out of order", form("LWO2", layer(9, 0), squareOf("FACE"), layer(2, 1),
                        squareOf("FACE"), chunk("TAGS", s0("white")), white2()), 4, ""),
                object("layers that are their own parents", form("LWO2", chunk("TAGS", s0("white")),
                        chunk("LAYR", u2(1, 0), f4(0, 0, 0), s0(""), u2(1)), squareOf("FACE"), white2()), 2, ""),
                object("layer cut short", form("LWO2", chunk("TAGS", s0("white")), chunk("LAYR", u2(1)),
                        squareOf("FACE"), white2()), 2, "pivot"),
                object("layers that are each other's parents", form("LWO2", chunk("TAGS", s0("white")),
                        chunk("LAYR", u2(0, 0), f4(0, 0, 0), s0(""), u2(1)), squareOf("FACE"),
                        chunk("LAYR", u2(1, 0), f4(0, 0, 0), s0(""), u2(0)), squareOf("FACE"), white2()), 4, ""),
                object("subdivision cage", form("LWO2", chunk("TAGS", s0("white")), squareOf("SUBD"), white2()), 2,
                        "cage"),
                object("curves only", form("LWO2", chunk("TAGS", s0("white")), squareOf("CURV"), white2()), ERROR,
                        "at least one polygon"));
    }
}
