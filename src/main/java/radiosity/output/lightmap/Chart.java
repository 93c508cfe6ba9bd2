package radiosity.output.lightmap;

import radiosity.scene.Vec3;

/**
 * A connected, plane part of a surface laid flat into a texture.
 *
 * @param u       unit, to the right in the texture
 * @param v       unit, downwards in the texture
 * @param left    of all points p . u, scene units
 * @param top     of all points p . v, scene units
 * @param samples per scene unit
 * @param width   texels, with {@link #PAD} on both sides
 * @param height  texels, with {@link #PAD} on both sides
 */
record Chart(Vec3 u, Vec3 v, double left, double top, double samples, int width, int height) {

    /** Texels round a chart that no other uses: what a filter reads beyond the edge. */
    static final int PAD = 2;

    /**
     * @param along  an edge, so that rectangles lie straight
     * @param normal unit
     * @param points all of the part
     * @param least  samples per scene unit
     * @param wanted more of them, as long as the chart is not wider or higher than that
     * @param most   texels
     */
    static Chart of(Vec3 along, Vec3 normal, Iterable<Vec3> points, double least, double wanted, int most) {
        Vec3 u = along.unit();
        Vec3 v = u.cross(normal);
        double left = Double.MAX_VALUE;
        double right = -Double.MAX_VALUE;
        double top = Double.MAX_VALUE;
        double bottom = -Double.MAX_VALUE;
        for (Vec3 p : points) {
            left = Math.min(left, p.dot(u));
            right = Math.max(right, p.dot(u));
            top = Math.min(top, p.dot(v));
            bottom = Math.max(bottom, p.dot(v));
        }
        double room = (most - 2 * PAD) / Math.max(right - left, bottom - top);
        double samples = Math.max(least, Math.min(wanted, room));
        return new Chart(u, v, left, top, samples, texels(right - left, samples), texels(bottom - top, samples));
    }

    private static int texels(double length, double samples) {
        return (int) Math.min(1 << 20, Math.ceil(length * samples)) + 2 * PAD;
    }

    /** Where a point lies, texels from the chart's left edge. */
    double x(Vec3 p) {
        return (p.dot(u) - left) * samples + PAD;
    }

    /** Where a point lies, texels from the chart's upper edge. */
    double y(Vec3 p) {
        return (p.dot(v) - top) * samples + PAD;
    }
}
