package radiosity.mesh.cut;

import radiosity.scene.Vec3;

/**
 * A segment of a face's plane along which another triangle stands on it or comes through.
 *
 * @param across unit vector in the face's plane, at right angles to the segment
 */
record Contact(Vec3 from, Vec3 to, Vec3 across) {

    double length() {
        return to.minus(from).length();
    }

    /** Distance of a point from the line, signed. */
    double beside(Vec3 p) {
        return p.minus(from).dot(across);
    }

    /** How far along the line a point lies, 0 at one end and {@link #length} at the other. */
    double along(Vec3 p) {
        return p.minus(from).dot(to.minus(from)) / length();
    }

    boolean holds(Vec3 p, double near) {
        double at = along(p);
        return Math.abs(beside(p)) <= near && at >= -near && at <= length() + near;
    }
}
