package radiosity.scene;

/**
 * An affine map of column vectors, a 3 x 4 matrix: each row holds 3 factors and an offset.
 *
 * @param m 12 numbers, row by row; not copied, not to be modified
 */
public record Affine(double[] m) {

    public static final Affine IDENTITY = new Affine(new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});

    public static Affine move(double x, double y, double z) {
        return new Affine(new double[] {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z});
    }

    public static Affine scale(double x, double y, double z) {
        return new Affine(new double[] {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0});
    }

    /** The map that applies the other map first and then this one. */
    public Affine times(Affine other) {
        double[] product = new double[12];
        for (int row = 0; row < 12; row += 4) {
            for (int column = 0; column < 4; column++) {
                product[row + column] = m[row] * other.m[column] + m[row + 1] * other.m[4 + column]
                        + m[row + 2] * other.m[8 + column] + (column == 3 ? m[row + 3] : 0);
            }
        }
        return new Affine(product);
    }

    /** Component k (0, 1 or 2) of the image of a point. */
    public double point(int k, double x, double y, double z) {
        return m[4 * k] * x + m[4 * k + 1] * y + m[4 * k + 2] * z + m[4 * k + 3];
    }

    /** The image of a direction, on which the offset has no effect; a new array of 3. */
    public double[] direction(double x, double y, double z) {
        double[] d = new double[3];
        for (int k = 0; k < 3; k++) {
            d[k] = m[4 * k] * x + m[4 * k + 1] * y + m[4 * k + 2] * z;
        }
        return d;
    }

    /** Determinant of the 3 x 3 factors; negative if the map mirrors. */
    public double determinant() {
        return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8])
                + m[2] * (m[4] * m[9] - m[5] * m[8]);
    }

    /** The direction whose image is d, by Cramer's rule; a new array of 3, not finite where the map is singular. */
    public double[] unturn(double[] d) {
        double det = determinant();
        return new double[] {
            (d[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (d[1] * m[10] - m[6] * d[2])
                    + m[2] * (d[1] * m[9] - m[5] * d[2])) / det,
            (m[0] * (d[1] * m[10] - m[6] * d[2]) - d[0] * (m[4] * m[10] - m[6] * m[8])
                    + m[2] * (m[4] * d[2] - d[1] * m[8])) / det,
            (m[0] * (m[5] * d[2] - d[1] * m[9]) - m[1] * (m[4] * d[2] - d[1] * m[8])
                    + d[0] * (m[4] * m[9] - m[5] * m[8])) / det};
    }

    /** The inverse map; its numbers are not finite where the map is singular. */
    public Affine inverse() {
        double[] inverse = new double[12];
        for (int column = 0; column < 4; column++) {
            double[] d = column == 3 ? new double[] {-m[3], -m[7], -m[11]}
                    : new double[] {column == 0 ? 1 : 0, column == 1 ? 1 : 0, column == 2 ? 1 : 0};
            double[] back = unturn(d);
            for (int row = 0; row < 3; row++) {
                inverse[4 * row + column] = back[row];
            }
        }
        return new Affine(inverse);
    }

    /** Whether all 12 numbers are finite, and the sum of their magnitudes too. */
    public boolean isFinite() {
        double sum = 0;
        for (double v : m) {
            sum += Math.abs(v);
        }
        return sum <= Double.MAX_VALUE;
    }
}
