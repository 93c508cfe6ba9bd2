package radiosity.viewer;

import java.util.function.BinaryOperator;
import radiosity.scene.Camera;
import radiosity.scene.Vec3;

/** The user's position and direction of view. Walking keeps the height; the pitch stays below the zenith. */
final class Walker {

    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final double STEEPEST = Math.toRadians(89);

    private final BinaryOperator<Vec3> allowed;
    private Vec3 eye;
    /** Angle about the vertical axis, radians, 0 towards -z, counter-clockwise seen from above. */
    private double heading;
    /** Angle above the horizon, radians. */
    private double pitch;
    /** Angle about the direction of view, radians, counter-clockwise; 0 except for a camera that was set up tilted. */
    private double roll;
    private double verticalHalfAngle;
    private boolean collides = true;

    /** @param allowed returns the part of a step that can be taken, given the eye's position and the step */
    Walker(Camera camera, BinaryOperator<Vec3> allowed) {
        this.allowed = allowed;
        stand(camera);
    }

    /** Takes over a camera's position and direction. */
    void stand(Camera camera) {
        eye = camera.position();
        Vec3 f = camera.forward();
        pitch = Math.asin(Math.max(-1, Math.min(1, f.y())));
        boolean vertical = Math.hypot(f.x(), f.z()) < 1e-9;
        Vec3 level = vertical ? camera.up().times(-Math.signum(f.y())) : f;
        heading = Math.atan2(-level.x(), -level.z());
        roll = Math.atan2(-camera.up().dot(right()), camera.up().dot(upright()));
        verticalHalfAngle = camera.verticalHalfAngle();
    }

    Vec3 forward() {
        return new Vec3(-Math.sin(heading) * Math.cos(pitch), Math.sin(pitch), -Math.cos(heading) * Math.cos(pitch));
    }

    /** Horizontal unit vector to the right of the direction of view. */
    private Vec3 right() {
        return new Vec3(Math.cos(heading), 0, -Math.sin(heading));
    }

    /** Unit vector up, perpendicular to the direction of view, before rolling. */
    private Vec3 upright() {
        return right().cross(forward());
    }

    /** @param aspect width / height of the window */
    Camera camera(double aspect) {
        Vec3 up = upright().times(Math.cos(roll)).minus(right().times(Math.sin(roll)));
        return new Camera(eye, forward(), up, verticalHalfAngle, aspect);
    }

    /**
     * Turns the direction of view.
     *
     * @param left radians
     * @param up   radians
     */
    void turn(double left, double up) {
        heading += left;
        pitch = Math.max(Math.min(-STEEPEST, pitch), Math.min(Math.max(STEEPEST, pitch), pitch + up));
    }

    /**
     * Walks, with directions relative to the horizon.
     *
     * @param ahead scene units
     * @param right scene units
     * @param up    scene units
     */
    void walk(double ahead, double right, double up) {
        Vec3 level = new Vec3(-Math.sin(heading), 0, -Math.cos(heading));
        Vec3 step = level.times(ahead).plus(right().times(right)).plus(UP.times(up));
        eye = eye.plus(collides ? allowed.apply(eye, step) : step);
    }

    boolean collides() {
        return collides;
    }

    void collide(boolean on) {
        collides = on;
    }
}
