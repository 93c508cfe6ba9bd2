package radiosity.mesh.cut;

import java.util.Optional;
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

    /** The part of the segment that lies inside of a triangle of the same plane; empty where none does. */
    Optional<Contact> within(Vec3 a, Vec3 b, Vec3 c) {
        Vec3 n = b.minus(a).cross(c.minus(a));
        Vec3[] corner = {a, b, c};
        double begin = 0;
        double end = 1;
        for (int k = 0; k < 3; k++) {
            Vec3 inwards = n.cross(corner[(k + 1) % 3].minus(corner[k])).unit();
            double p = from.minus(corner[k]).dot(inwards);
            double q = to.minus(corner[k]).dot(inwards);
            if (p <= 0 && q <= 0) {
                return Optional.empty();
            }
            begin = p < 0 ? Math.max(begin, p / (p - q)) : begin;
            end = q < 0 ? Math.min(end, p / (p - q)) : end;
        }
        Vec3 d = to.minus(from);
        return begin >= end ? Optional.empty()
                : Optional.of(new Contact(from.plus(d.times(begin)), from.plus(d.times(end)), across));
    }
}
