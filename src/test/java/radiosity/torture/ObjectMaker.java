package radiosity.torture;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Writes LightWave objects, of the old format LWOB or of LWO2, polygon by polygon. */
final class ObjectMaker {

    private final List<double[]> points = new ArrayList<>();
    private final List<int[]> polygons = new ArrayList<>();
    private final List<Material> materials = new ArrayList<>();
    private final List<Material> used = new ArrayList<>();

    /** A part of a file that is being written. */
    private interface Part {
        void to(DataOutputStream out) throws IOException;
    }

    /**
     * A polygon whose visible side looks at a point.
     *
     * @param eye     null: the corners' order decides, clockwise seen from the visible side
     * @param corners x, y, z each, left-handed
     */
    void polygon(Material material, double[] eye, double[]... corners) {
        boolean turn = eye != null && towards(eye, corners) < 0;
        int[] polygon = new int[corners.length];
        for (int i = 0; i < corners.length; i++) {
            polygon[turn ? corners.length - 1 - i : i] = points.size();
            points.add(corners[i]);
        }
        polygons.add(polygon);
        used.add(material);
        if (!materials.contains(material)) {
            materials.add(material);
        }
    }

    private static double towards(double[] eye, double[][] corners) {
        double[] a = minus(corners[1], corners[0]);
        double[] b = minus(corners[corners.length - 1], corners[0]);
        double[] e = minus(eye, corners[0]);
        return (a[1] * b[2] - a[2] * b[1]) * e[0] + (a[2] * b[0] - a[0] * b[2]) * e[1]
                + (a[0] * b[1] - a[1] * b[0]) * e[2];
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    /**
     * The six sides of a box.
     *
     * @param inside whether they are seen from its middle; else from outside
     * @param sides  a material each for -x, +x, -y, +y, -z, +z; null leaves a side open
     */
    void box(double[] low, double[] high, boolean inside, Material... sides) {
        for (int side = 0; side < 6; side++) {
            if (sides[side] == null) {
                continue;
            }
            int axis = side / 2;
            double[] eye = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
            double level = side % 2 == 0 ? low[axis] : high[axis];
            if (!inside) {
                eye[axis] = level + (level - eye[axis]);
            }
            rectangle(sides[side], eye, axis, level, low, high);
        }
    }

    /** A rectangle across an axis. */
    void rectangle(Material material, double[] eye, int axis, double level, double[] low, double[] high) {
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        double[][] corners = new double[4][3];
        for (int i = 0; i < 4; i++) {
            corners[i][axis] = level;
            corners[i][u] = i == 1 || i == 2 ? high[u] : low[u];
            corners[i][v] = i >= 2 ? high[v] : low[v];
        }
        polygon(material, eye, corners);
    }

    /** Moves and scales every point: p * scale + shift. */
    void transform(double scale, double[] shift) {
        for (double[] point : points) {
            for (int k = 0; k < 3; k++) {
                point[k] = point[k] * scale + shift[k];
            }
        }
    }

    /** Sum of the polygons' areas, square units; twice where they have two sides. */
    double area() {
        double area = 0;
        for (int p = 0; p < polygons.size(); p++) {
            double[] sum = new double[3];
            int[] polygon = polygons.get(p);
            for (int i = 1; i + 1 < polygon.length; i++) {
                double[] a = minus(points.get(polygon[i]), points.get(polygon[0]));
                double[] b = minus(points.get(polygon[i + 1]), points.get(polygon[0]));
                for (int k = 0; k < 3; k++) {
                    sum[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
                }
            }
            area += Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / 2
                    * (used.get(p).twoSided() ? 2 : 1);
        }
        return area;
    }

    byte[] lwob() throws IOException {
        return form("LWOB", out -> {
            points(out);
            chunk(out, "SRFS", c -> {
                for (Material material : materials) {
                    name(c, name(material));
                }
            });
            chunk(out, "POLS", c -> {
                for (int p = 0; p < polygons.size(); p++) {
                    c.writeShort(polygons.get(p).length);
                    for (int corner : polygons.get(p)) {
                        c.writeShort(corner);
                    }
                    c.writeShort(materials.indexOf(used.get(p)) + 1);
                }
            });
            for (Material material : materials) {
                chunk(out, "SURF", c -> oldSurface(c, material));
            }
        });
    }

    private void oldSurface(DataOutputStream out, Material m) throws IOException {
        name(out, name(m));
        sub(out, "COLR", c -> {
            for (int value : m.colour()) {
                c.writeByte(value);
            }
            c.writeByte(0);
        });
        sub(out, "FLAG", c -> c.writeShort(m.twoSided() ? 0x100 : 0));
        sub(out, "VDIF", c -> c.writeFloat((float) m.diffuse()));
        sub(out, "VLUM", c -> c.writeFloat((float) m.luminosity()));
        sub(out, "VSPC", c -> c.writeFloat((float) m.specular()));
        if (m.image() != null) {
            sub(out, "CTEX", c -> name(c, "Planar Image Map"));
            sub(out, "TIMG", c -> name(c, m.image()));
            sub(out, "TFLG", c -> c.writeShort(2));
            sub(out, "TSIZ", c -> vector(c, 3, 3, 3));
            sub(out, "TWRP", c -> {
                c.writeShort(2);
                c.writeShort(2);
            });
        }
    }

    /** Of LWO2; its surfaces have no images here. */
    byte[] lwo2() throws IOException {
        return form("LWO2", out -> {
            chunk(out, "TAGS", c -> {
                for (Material material : materials) {
                    name(c, name(material));
                }
            });
            chunk(out, "LAYR", c -> {
                c.writeInt(0);
                vector(c, 0, 0, 0);
                name(c, "");
            });
            points(out);
            chunk(out, "POLS", c -> {
                c.writeBytes("FACE");
                for (int[] polygon : polygons) {
                    c.writeShort(polygon.length);
                    for (int corner : polygon) {
                        c.writeShort(corner);
                    }
                }
            });
            chunk(out, "PTAG", c -> {
                c.writeBytes("SURF");
                for (int p = 0; p < polygons.size(); p++) {
                    c.writeShort(p);
                    c.writeShort(materials.indexOf(used.get(p)));
                }
            });
            for (Material material : materials) {
                chunk(out, "SURF", c -> newSurface(c, material));
            }
        });
    }

    private void newSurface(DataOutputStream out, Material m) throws IOException {
        name(out, name(m));
        name(out, "");
        sub(out, "COLR", c -> {
            vector(c, m.colour()[0] / 255.0, m.colour()[1] / 255.0, m.colour()[2] / 255.0);
            c.writeShort(0);
        });
        share(out, "DIFF", m.diffuse());
        share(out, "LUMI", m.luminosity());
        share(out, "SPEC", m.specular());
        sub(out, "SIDE", c -> c.writeShort(m.twoSided() ? 3 : 1));
    }

    /** No two surfaces of an object are called alike. */
    private String name(Material material) {
        return material.name() + " " + materials.indexOf(material);
    }

    private static void share(DataOutputStream out, String id, double value) throws IOException {
        sub(out, id, c -> {
            c.writeFloat((float) value);
            c.writeShort(0);
        });
    }

    private void points(DataOutputStream out) throws IOException {
        chunk(out, "PNTS", c -> {
            for (double[] point : points) {
                vector(c, point);
            }
        });
    }

    private static void vector(DataOutputStream out, double... values) throws IOException {
        for (double value : values) {
            out.writeFloat((float) value);
        }
    }

    private static byte[] form(String type, Part content) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        chunk(new DataOutputStream(bytes), "FORM", out -> {
            out.writeBytes(type);
            content.to(out);
        });
        return bytes.toByteArray();
    }

    private static void chunk(DataOutputStream out, String id, Part content) throws IOException {
        byte[] bytes = bytes(content);
        out.writeBytes(id);
        out.writeInt(bytes.length);
        out.write(bytes);
        out.write(new byte[bytes.length & 1]);
    }

    private static void sub(DataOutputStream out, String id, Part content) throws IOException {
        byte[] bytes = bytes(content);
        out.writeBytes(id);
        out.writeShort(bytes.length);
        out.write(bytes);
        out.write(new byte[bytes.length & 1]);
    }

    private static byte[] bytes(Part content) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        content.to(new DataOutputStream(bytes));
        return bytes.toByteArray();
    }

    /** Zero-terminated and of an even number of bytes. */
    private static void name(DataOutputStream out, String name) throws IOException {
        byte[] bytes = name.getBytes(StandardCharsets.ISO_8859_1);
        out.write(bytes);
        out.write(new byte[2 - (bytes.length & 1)]);
    }
}
