package radiosity.formfactor;

/**
 * Cones that hold all normals below each node of a {@link ShooterHierarchy}: by them is known what faces away (L.
 * Shirman, S. Abi-Ezzi, The cone of normals technique for fast processing of curved patches, 1993).
 */
final class NormalCones {

    /** 3 per node: direction of length 1; 0 where there is none. */
    private final float[] axis;
    /** 2 per node: cosine and sine of the angle between the axis and the farthest normal, 0 to 180 degrees. */
    private final float[] angle;

    NormalCones(int nodes) {
        axis = new float[3 * nodes];
        angle = new float[2 * nodes];
    }

    /** @param normal of all that lies below a node, 3 from {@code at}; not modified */
    void set(int node, float[] normal, int at) {
        System.arraycopy(normal, at, axis, 3 * node, 3);
        angle[2 * node] = 1;
    }

    /** The cone around those of two nodes. */
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

    /** Cosine of the angle within which an axis has the cone of another node. */
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
     * The largest cosine at which what lies below a node may stand to a point.
     *
     * @param ex, ey, ez from the point to the middle of the node's sphere
     * @param d         length of that
     * @param sin       of the angle between the sphere's middle and its rim, seen from the point, below 1
     * @param cos       of the same angle
     * @return 0 or less where all of it faces away
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

    /** The largest cosine to a sphere, from that to its middle and the angle between its middle and its rim. */
    static float most(float middle, float sin, float cos) {
        return middle >= cos ? 1 : middle * cos + aside(middle) * sin;
    }

    private static float aside(float cosine) {
        return (float) Math.sqrt(Math.max(0, 1 - cosine * cosine));
    }
}
