package radiosity.mesh.cut;

import radiosity.scene.Vec3;

/**
 * A segment in the plane of a face along which another triangle stands on the face or passes through it.
 *
 * @param across unit vector in the face's plane, at right angles to the segment
 */
record Contact(Vec3 from, Vec3 to, Vec3 across) {

    double length() {
        return to.minus(from).length();
    }

    /** Signed distance of a point from the line through the segment, scene units. */
    double beside(Vec3 p) {
        return p.minus(from).dot(across);
    }

    /** Position of a point along the line, scene units: 0 at {@code from} and {@link #length} at {@code to}. */
    double along(Vec3 p) {
        return p.minus(from).dot(to.minus(from)) / length();
    }

    /** Whether the segment may have a point in a sphere; false is certain. */
    boolean reaches(Vec3 middle, double radius) {
        return Math.abs(beside(middle)) <= radius && along(middle) >= -radius && along(middle) <= length() + radius;
    }

    boolean holds(Vec3 p, double near) {
        double at = along(p);
        return Math.abs(beside(p)) <= near && at >= -near && at <= length() + near;
    }
}
