package radiosity.scene;

import java.util.Optional;

/**
 * A pinhole camera.
 *
 * @param position          eye point, scene units
 * @param forward           unit direction of view
 * @param up                unit direction, at right angles to forward
 * @param verticalHalfAngle half of the vertical angle of view, radians, in (0, pi/2)
 * @param aspect            width of the picture / its height, above 0
 */
public record Camera(Vec3 position, Vec3 forward, Vec3 up, double verticalHalfAngle, double aspect) {

    public Camera {
        if (!(verticalHalfAngle > 0 && verticalHalfAngle < Math.PI / 2) || !(aspect > 0)) {
            throw new IllegalArgumentException("camera: expected a half angle in (0, pi/2) and an aspect above 0, got "
                    + verticalHalfAngle + " and " + aspect);
        }
    }

    /**
     * A camera whose directions are made unit directions at right angles.
     *
     * @param forward direction of view, of any length
     * @param up      upwards in the picture, of any length, not along forward
     * @return empty where position or directions are not finite or do not span a picture, or where the half angle is
     *         within 1e-9 of 0 or 1e-6 of pi/2, or the aspect not in (1e-6, 1e6)
     */
    public static Optional<Camera> of(Vec3 position, Vec3 forward, Vec3 up, double verticalHalfAngle, double aspect) {
        Vec3 ahead = forward.unit();
        Vec3 above = up.minus(ahead.times(up.dot(ahead))).unit();
        boolean sound = position.isFinite() && ahead.isFinite() && above.isFinite() && ahead.length() > 0.5
                && above.length() > 0.5 && verticalHalfAngle > 1e-9 && verticalHalfAngle < Math.PI / 2 - 1e-6
                && aspect > 1e-6 && aspect < 1e6;
        return sound ? Optional.of(new Camera(position, ahead, above, verticalHalfAngle, aspect)) : Optional.empty();
    }

    /** Whether what lies in a direction from the eye, of any length, is within the edges of the picture. */
    public boolean frames(Vec3 direction) {
        double depth = direction.dot(forward);
        double half = depth * StrictMath.tan(verticalHalfAngle);
        return depth > 0 && Math.abs(direction.dot(up)) <= half
                && Math.abs(direction.dot(forward.cross(up))) <= half * aspect;
    }

    /**
     * Unit direction from the eye through a point of the picture.
     *
     * @param x from -1, left edge, to 1, right edge
     * @param y from -1, lower edge, to 1, upper edge
     */
    public Vec3 direction(double x, double y) {
        double tangent = StrictMath.tan(verticalHalfAngle);
        Vec3 right = forward.cross(up);
        return forward.plus(right.times(x * tangent * aspect)).plus(up.times(y * tangent)).unit();
    }
}
