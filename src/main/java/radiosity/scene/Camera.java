package radiosity.scene;

/**
 * A pinhole camera.
 *
 * @param position          eye, scene units
 * @param forward           unit direction of view
 * @param up                unit direction, at right angles to forward
 * @param verticalHalfAngle radians, in (0, pi/2)
 * @param aspect            width of the picture / its height
 */
public record Camera(Vec3 position, Vec3 forward, Vec3 up, double verticalHalfAngle, double aspect) {

    public Camera {
        if (!(verticalHalfAngle > 0 && verticalHalfAngle < Math.PI / 2) || !(aspect > 0)) {
            throw new IllegalArgumentException("camera: expected a half angle in (0, pi/2) and an aspect above 0, got "
                    + verticalHalfAngle + " and " + aspect);
        }
    }
}
