package radiosity.scene;

/**
 * How a luminaire's intensity depends on the direction: intensities on a grid of two angles, interpolated bilinearly.
 *
 * <p>Angles are measured from the axes of the luminaire: <i>down</i>, where both angles are 0, <i>zero</i>, in which
 * the plane of horizontal angle 0 lies, and <i>across</i> = zero x down, in which C90 lies. Source of the angles:
 * ANSI/IES LM-63-19; for EULUMDAT, which has C and gamma, CIE 121.
 *
 * @param type       coordinate system of the angles
 * @param horizontal degrees, ascending, at least 2: 0 to 360 for type C, -90 to 90 for types A and B
 * @param vertical   degrees, ascending, at least 2: within 0 to 180 for type C, -90 to 90 for types A and B; the
 *                   intensity is 0 beyond them
 * @param candela    intensity, cd, at least 0; one per vertical angle for the first horizontal angle, then for the next
 */
public record LuminousIntensity(Type type, double[] horizontal, double[] vertical, double[] candela) {

    /** Coordinate systems of the two angles of a direction. */
    public enum Type {
        /** The vertical angle is measured upwards from straight ahead, in a plane turned by the horizontal angle. */
        A,
        /** The horizontal angle is measured sideways, in a plane turned upwards by the vertical angle. */
        B,
        /**
         * The horizontal angle C runs counter-clockwise seen from above, the vertical angle gamma from straight down.
         */
        C
    }

    /** Tolerance of comparisons with the first and last angle, degrees; angles in files have only a few digits. */
    private static final double ROUNDING = 1e-6;

    /**
     * Checks all values.
     *
     * @throws IllegalArgumentException where angles do not ascend, or an intensity is negative or not finite
     */
    public LuminousIntensity {
        ascending(horizontal);
        ascending(vertical);
        if (candela.length != horizontal.length * vertical.length) {
            throw new IllegalArgumentException("intensity: expected " + horizontal.length * vertical.length
                    + " values, got " + candela.length);
        }
        for (double i : candela) {
            if (!(i >= 0 && Double.isFinite(i))) {
                throw new IllegalArgumentException("intensity: expected at least 0 cd, got " + i);
            }
        }
    }

    private static void ascending(double[] angles) {
        for (int i = 1; i < Math.max(2, angles.length); i++) {
            if (angles.length < 2 || !(angles[i] > angles[i - 1])) {
                throw new IllegalArgumentException("intensity: expected at least 2 angles that ascend, got "
                        + (angles.length < 2 ? angles.length : angles[i - 1] + ", " + angles[i]));
            }
        }
    }

    /** The largest intensity, cd. */
    public double max() {
        double most = 0;
        for (double i : candela) {
            most = Math.max(most, i);
        }
        return most;
    }

    /** Intensity, cd, in a direction of any length above 0, given by its components along the luminaire's axes. */
    public double towards(double down, double zero, double across) {
        double h;
        double v;
        switch (type) {
            case A -> {
                v = StrictMath.atan2(zero, StrictMath.hypot(down, across));
                h = StrictMath.atan2(-across, down);
            }
            case B -> {
                h = StrictMath.atan2(-across, StrictMath.hypot(down, zero));
                v = StrictMath.atan2(zero, down);
            }
            default -> {
                h = StrictMath.atan2(across, zero);
                v = StrictMath.atan2(StrictMath.hypot(zero, across), down);
            }
        }
        double degrees = StrictMath.toDegrees(h);
        return at(type == Type.C && degrees < 0 ? degrees + 360 : degrees, StrictMath.toDegrees(v));
    }

    /** Intensity, cd, at two angles in degrees; 0 outside of the grid. */
    public double at(double horizontalAngle, double verticalAngle) {
        int i = interval(horizontal, horizontalAngle);
        int k = interval(vertical, verticalAngle);
        if (i < 0 || k < 0) {
            return 0;
        }
        double s = part(horizontal, i, horizontalAngle);
        double t = part(vertical, k, verticalAngle);
        int row = i * vertical.length + k;
        int next = row + vertical.length;
        return (1 - s) * ((1 - t) * candela[row] + t * candela[row + 1])
                + s * ((1 - t) * candela[next] + t * candela[next + 1]);
    }

    private static double part(double[] angles, int i, double angle) {
        return Math.max(0, Math.min(1, (angle - angles[i]) / (angles[i + 1] - angles[i])));
    }

    /** Index i such that the angle lies in the interval from angles[i] to angles[i + 1]; -1 outside of the grid. */
    private static int interval(double[] angles, double angle) {
        int last = angles.length - 1;
        if (!(angle >= angles[0] - ROUNDING && angle <= angles[last] + ROUNDING)) {
            return -1;
        }
        int low = 0;
        for (int high = last; high - low > 1;) {
            int middle = (low + high) >>> 1;
            if (angles[middle] <= angle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /**
     * Luminous flux of type C intensities, lm: the intensity, linear in both angles within a cell of the grid, is
     * integrated exactly over the sphere.
     */
    public double flux() {
        double sum = 0;
        for (int i = 0; i + 1 < horizontal.length; i++) {
            double width = StrictMath.toRadians(horizontal[i + 1] - horizontal[i]);
            for (int k = 0; k + 1 < vertical.length; k++) {
                double a = StrictMath.toRadians(vertical[k]);
                double b = StrictMath.toRadians(vertical[k + 1]);
                int row = i * vertical.length + k;
                double atA = (candela[row] + candela[row + vertical.length]) / 2;
                double atB = (candela[row + 1] + candela[row + 1 + vertical.length]) / 2;
                double slope = (atB - atA) / (b - a);
                sum += width * (atA * StrictMath.cos(a) - atB * StrictMath.cos(b)
                        + slope * (StrictMath.sin(b) - StrictMath.sin(a)));
            }
        }
        return sum;
    }
}
