package radiosity.mesh.face;

/**
 * The path of a node below its face, as a number: a 1, then two bits per level for the child taken; 1 for the face.
 *
 * <p>Children 0, 1, 2 keep the corner with their number; child 3 is the middle one, its corner k opposite the parent's.
 */
public final class NodePath {

    public static final long FACE = 1;
    /** Deepest level: weights of corners are exact multiples of 2^-30. */
    public static final int MAX_LEVEL = 30;
    /** The weight 1 of a corner, as an integer. */
    public static final int ONE = 1 << MAX_LEVEL;

    private NodePath() { }

    public static long child(long path, int k) {
        return path << 2 | k;
    }

    public static int level(long path) {
        return (63 - Long.numberOfLeadingZeros(path)) / 2;
    }

    /** The child taken at a level; level 1 is the first below the face. */
    public static int step(long path, int level) {
        return (int) (path >>> 2 * (level(path) - level)) & 3;
    }

    /**
     * Finds the weights of the face's corners at a node's corners, in units of 2^-30.
     *
     * @param weights modified: 9, corner by corner
     */
    public static void weights(long path, int[] weights) {
        for (int i = 0; i < 9; i++) {
            weights[i] = i % 4 == 0 ? ONE : 0;
        }
        for (int level = 1; level <= level(path); level++) {
            descend(weights, step(path, level));
        }
    }

    private static void descend(int[] w, int child) {
        for (int a = 0; a < 3; a++) {
            int m01 = (w[a] + w[3 + a]) >> 1;
            int m12 = (w[3 + a] + w[6 + a]) >> 1;
            int m20 = (w[6 + a] + w[a]) >> 1;
            switch (child) {
                case 0 -> {
                    w[3 + a] = m01;
                    w[6 + a] = m20;
                }
                case 1 -> {
                    w[a] = m01;
                    w[6 + a] = m12;
                }
                case 2 -> {
                    w[a] = m20;
                    w[3 + a] = m12;
                }
                default -> {
                    w[a] = m12;
                    w[3 + a] = m20;
                    w[6 + a] = m01;
                }
            }
        }
    }
}
