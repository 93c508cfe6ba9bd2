package radiosity.output.lightmap;

import java.util.List;
import radiosity.output.mesh.Elements;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/**
 * The rectangle of a texture in which one connected, plane part of a surface lies.
 *
 * @param u       unit vector, to the right in the texture
 * @param v       unit vector, downwards in the texture
 * @param left    least p . u of all points p of the part, scene units
 * @param top     least p . v of all points p of the part, scene units
 * @param samples texels per scene unit
 * @param width   texels, with a margin of {@link #PAD} on both sides
 * @param height  texels, with a margin of {@link #PAD} on both sides
 */
record Chart(Vec3 u, Vec3 v, double left, double top, double samples, int width, int height) {

    /** Margin round a chart that belongs to no other chart, texels: as far as filters read beyond an edge. */
    static final int PAD = 2;

    /**
     * Makes the chart of a part. An edge of the first face becomes horizontal, so that rectangles lie straight.
     *
     * @param faces  of the part, at least one: 2 * original triangle, + 1 for its back
     * @param least  texels per scene unit that the chart has at least
     * @param wanted texels per scene unit that the chart has as long as it is no wider or higher than {@code most}
     * @param most   texels
     */
    static Chart of(Scene scene, List<Integer> faces, double least, double wanted, int most) {
        int first = faces.get(0);
        Vec3 u = Elements.corner(scene, first, 1).minus(Elements.corner(scene, first, 0)).unit();
        Vec3 v = u.cross(Elements.normal(scene, first));
        double left = Double.MAX_VALUE;
        double right = -Double.MAX_VALUE;
        double top = Double.MAX_VALUE;
        double bottom = -Double.MAX_VALUE;
        for (int face : faces) {
            for (int k = 0; k < 3; k++) {
                Vec3 p = Elements.corner(scene, face, k);
                left = Math.min(left, p.dot(u));
                right = Math.max(right, p.dot(u));
                top = Math.min(top, p.dot(v));
                bottom = Math.max(bottom, p.dot(v));
            }
        }
        double room = (most - 2 * PAD) / Math.max(right - left, bottom - top);
        double samples = Math.max(least, Math.min(wanted, room));
        return new Chart(u, v, left, top, samples, texels(right - left, samples), texels(bottom - top, samples));
    }

    private static int texels(double length, double samples) {
        return (int) Math.min(1 << 20, Math.ceil(length * samples)) + 2 * PAD;
    }

    /** Horizontal position of a point, texels from the chart's left edge. */
    double x(Vec3 p) {
        return (p.dot(u) - left) * samples + PAD;
    }

    /** Vertical position of a point, texels from the chart's upper edge. */
    double y(Vec3 p) {
        return (p.dot(v) - top) * samples + PAD;
    }
}
