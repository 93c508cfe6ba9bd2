package radiosity.scene;

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
