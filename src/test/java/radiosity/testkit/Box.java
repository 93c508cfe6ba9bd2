package radiosity.testkit;

import radiosity.scene.Vec3;

/**
 * A box with edges along the axes.
 *
 * @param low  its corner with the smallest coordinates
 * @param high its corner with the largest
 */
public record Box(Vec3 low, Vec3 high) {

    /** The cube from the origin to (1, 1, 1). */
    public static final Box UNIT = new Box(Vec3.ZERO, new Vec3(1, 1, 1));

    /** Corners per side as bits: 1 high x, 2 high y, 4 high z; counter-clockwise seen from inside. */
    private static final int[][] CORNERS = {
        {0, 2, 6, 4}, {5, 7, 3, 1}, {0, 4, 5, 1}, {3, 7, 6, 2}, {0, 1, 3, 2}, {6, 7, 5, 4}};

    /** @param side 0 low x, 1 high x, 2 low y, 3 high y, 4 low z, 5 high z */
    public Vec3[] inside(int side) {
        Vec3[] polygon = new Vec3[4];
        for (int i = 0; i < 4; i++) {
            polygon[i] = corner(CORNERS[side][i]);
        }
        return polygon;
    }

    private Vec3 corner(int bits) {
        return new Vec3((bits & 1) == 0 ? low.x() : high.x(), (bits & 2) == 0 ? low.y() : high.y(),
                (bits & 4) == 0 ? low.z() : high.z());
    }

    /** Length along an axis: 0 x, 1 y, 2 z. */
    public double size(int axis) {
        Vec3 d = high.minus(low);
        return axis == 0 ? d.x() : axis == 1 ? d.y() : d.z();
    }
}
