package radiosity.formfactor;

/**
 * Cones of normals, one per node of a {@link ShooterHierarchy}. A cone contains all normals below its node, so it tells
 * whether the whole node faces away from a point (L. Shirman, S. Abi-Ezzi, The cone of normals technique for fast
 * processing of curved patches, 1993).
 */
final class NormalCones {

    /** 3 per node: axis of the cone, length 1; all 0 where the axes of both children cancel. */
    private final float[] axis;
    /** 2 per node: cosine and sine of the cone's half angle, 0 to 180 degrees. */
    private final float[] angle;

    NormalCones(int nodes) {
        axis = new float[3 * nodes];
        angle = new float[2 * nodes];
    }

    /** @param normal normal of all triangles below the node, 3 numbers from {@code at}; not modified */
    void set(int node, float[] normal, int at) {
        System.arraycopy(normal, at, axis, 3 * node, 3);
        angle[2 * node] = 1;
    }

    /** Sets the cone of a node to one that contains the cones of nodes a and b. */
    void enclose(int node, int a, int b) {
        double x = (double) axis[3 * a] + axis[3 * b];
        double y = (double) axis[3 * a + 1] + axis[3 * b + 1];
        double z = (double) axis[3 * a + 2] + axis[3 * b + 2];
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length == 0) {
            angle[2 * node] = -1;
            return;
        }
        axis[3 * node] = (float) (x / length);
        axis[3 * node + 1] = (float) (y / length);
        axis[3 * node + 2] = (float) (z / length);
        double ca = widened(node, a);
        double cb = widened(node, b);
        double cos = Math.max(-1, Math.min(ca, cb) - 1e-6);
        angle[2 * node] = (float) cos;
        angle[2 * node + 1] = (float) Math.sqrt(1 - cos * cos);
    }

    /** Cosine of the half angle at which a cone around the axis of {@code node} contains the cone of {@code of}. */
    private double widened(int node, int of) {
        double dot = (double) axis[3 * node] * axis[3 * of] + (double) axis[3 * node + 1] * axis[3 * of + 1]
                + (double) axis[3 * node + 2] * axis[3 * of + 2];
        double cos = Math.max(-1, Math.min(1, dot));
        double sin = Math.sqrt(1 - cos * cos);
        double c = angle[2 * of];
        double s = angle[2 * of + 1];
        return sin * c + cos * s < 0 ? -1 : cos * c - sin * s;
    }

    /**
     * Upper bound of the cosine between a normal below a node and the direction to a point outside the node's sphere.
     *
     * @param ex, ey, ez vector from the point to the middle of the node's sphere
     * @param d         length of the vector
     * @param sin       sine of the angle between the sphere's middle and its rim as seen from the point, below 1
     * @param cos       cosine of the same angle
     * @return 0 or less where the whole node faces away from the point
     */
    float most(int node, float ex, float ey, float ez, float d, float sin, float cos) {
        float towards = -(axis[3 * node] * ex + axis[3 * node + 1] * ey + axis[3 * node + 2] * ez) / d;
        float ca = angle[2 * node];
        float sa = angle[2 * node + 1];
        if (towards >= ca) {
            return 1;
        }
        float aside = aside(towards);
        float c = towards * ca + aside * sa;
        float s = aside * ca - towards * sa;
        return c >= cos ? 1 : c * cos + s * sin;
    }

    /** Largest cosine between a normal and directions into a sphere, from the cosine to the sphere's middle. */
    static float most(float middle, float sin, float cos) {
        return middle >= cos ? 1 : middle * cos + aside(middle) * sin;
    }

    /** The sine that belongs to a cosine. */
    private static float aside(float cosine) {
        return (float) Math.sqrt(Math.max(0, 1 - cosine * cosine));
    }
}
