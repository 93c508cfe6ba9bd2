package radiosity.scene;

/**
 * A point or a direction in a right-handed space.
 *
 * @param x to the right
 * @param y up
 * @param z towards the viewer
 */
public record Vec3(double x, double y, double z) {

    public static final Vec3 ZERO = new Vec3(0, 0, 0);

    public Vec3 plus(Vec3 v) {
        return new Vec3(x + v.x, y + v.y, z + v.z);
    }

    public Vec3 minus(Vec3 v) {
        return new Vec3(x - v.x, y - v.y, z - v.z);
    }

    public Vec3 times(double s) {
        return new Vec3(x * s, y * s, z * s);
    }

    public double dot(Vec3 v) {
        return x * v.x + y * v.y + z * v.z;
    }

    public Vec3 cross(Vec3 v) {
        return new Vec3(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x);
    }

    public double length() {
        double square = dot(this);
        if (square >= Double.MIN_NORMAL && square <= Double.MAX_VALUE) {
            return Math.sqrt(square);
        }
        double largest = largest();
        return largest > 0 && largest <= Double.MAX_VALUE ? largest * dividedBy(largest).length() : largest;
    }

    private double largest() {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    private Vec3 dividedBy(double s) {
        return new Vec3(x / s, y / s, z / s);
    }

    /** This direction with length 1; the zero vector stays zero. */
    public Vec3 unit() {
        double square = dot(this);
        if (square >= Double.MIN_NORMAL && square <= Double.MAX_VALUE) {
            return times(1 / Math.sqrt(square));
        }
        double largest = largest();
        return largest > 0 && largest <= Double.MAX_VALUE ? dividedBy(largest).unit() : this;
    }

    /** A unit vector at right angles to this unit vector. */
    public Vec3 perpendicular() {
        return cross(Math.abs(x) < 0.6 ? new Vec3(1, 0, 0) : new Vec3(0, 1, 0)).unit();
    }

    /** Component along x (0), y (1) or z (2). */
    public double coordinate(int axis) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    /** Writes x, y and z as floats to the entries {@code at} to {@code at + 2} of an array. */
    public void write(float[] to, int at) {
        to[at] = (float) x;
        to[at + 1] = (float) y;
        to[at + 2] = (float) z;
    }

    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
    }
}
