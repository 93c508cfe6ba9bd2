package radiosity.formfactor;

import java.util.function.Predicate;
import radiosity.scene.Light;
import radiosity.scene.Vec3;
import radiosity.util.Hash;

/**
 * The light of a sky that a point receives through openings of any shape.
 *
 * <p>The circle below the point's hemisphere (W. Nusselt, 1928) is mapped to a square (P. Shirley, K. Chiu, A low
 * distortion map between disk and square, 1997), and rays go to the corners and middles of square cells. A cell is
 * divided where some of its rays see the sky and others do not, until what edges leave uncertain is .2 % of what
 * the point sees. The smallest parts on an edge count by a random point each: edges of windows lie along the rows of
 * cells, and by corners all parts of such an edge would err alike. An opening smaller than a cell may be missed, such
 * as one of 1 m from 24 m away.
 *
 * <p>Luminances: CIE S 011/E:2003, Spatial distribution of daylight - CIE standard general sky.
 */
final class Sky {

    /** Cells along a side of the square. */
    private static final int SIDE = 48;
    /** Parts along a side of a cell that is divided down to the smallest parts; a power of 2. */
    private static final int PARTS = 16;
    /** Standard deviation that edges may leave, relative to the point's irradiance. */
    private static final double UNCERTAIN = 0.002;
    /** Sine of an elevation up to which a direction is on the horizon. */
    private static final double LEVEL = 1e-12;
    /** Parameters a to e of the CIE general sky of type 12: gradation (a, b) and scattering (c, d, e). */
    private static final double A = -1;
    private static final double B = -0.32;
    private static final double C = 10;
    private static final double D = -3;
    private static final double E = 0.45;

    /** 3 per corner of the cells, row by row: components of its direction along a point's two tangents and normal. */
    private static final double[] CORNERS = corners();

    private final Light light;
    private final Vec3 sun;
    /** Factor that makes the irradiance of a level place with a free sky 1. */
    private final double scale;

    Sky(Light light) {
        this.light = light;
        sun = light.direction().unit().times(-1);
        scale = 1 / new Place(light.up(), d -> true).all();
    }

    private static double[] corners() {
        double[] corners = new double[3 * (SIDE + 1) * (SIDE + 1)];
        for (int i = 0; i < corners.length / 3; i++) {
            System.arraycopy(direction(i / (SIDE + 1) * PARTS, i % (SIDE + 1) * PARTS), 0, corners, 3 * i, 3);
        }
        return corners;
    }

    /** Direction of a point of the square: components along two tangents and the normal; row and column in parts. */
    private static double[] direction(double row, double column) {
        double a = 2 * row / (SIDE * PARTS) - 1;
        double b = 2 * column / (SIDE * PARTS) - 1;
        boolean byA = Math.abs(a) > Math.abs(b);
        double r = byA ? a : b;
        double angle = r == 0 ? 0 : byA ? Math.PI / 4 * (b / a) : Math.PI / 2 - Math.PI / 4 * (a / b);
        return new double[] {r * StrictMath.cos(angle), r * StrictMath.sin(angle), Math.sqrt(Math.max(0, 1 - r * r))};
    }

    /**
     * Irradiance of a point, relative to that of a level place with a free sky.
     *
     * @param n    normal of the point, length 1
     * @param free whether no triangle stands in the way in a direction from the point
     */
    double irradiance(Vec3 n, Predicate<Vec3> free) {
        return scale * new Place(n, free).all();
    }

    /** Luminance in a direction of length 1; a sky of luminance 1 everywhere gives a level place an irradiance of 1. */
    double towards(Vec3 d) {
        double height = d.dot(light.up());
        return height <= 0 ? 0 : scale * luminance(d, height);
    }

    /** Luminance in direction d, in an arbitrary unit; height is the sine of the elevation, above 0. */
    private double luminance(Vec3 d, double height) {
        return switch (light.kind()) {
            case SKY_OVERCAST -> 1 + 2 * height;
            case SKY_CLEAR -> {
                double angle = StrictMath.acos(Math.max(-1, Math.min(1, d.dot(sun))));
                double aboutSun = 1 + C * (StrictMath.exp(D * angle) - StrictMath.exp(D * Math.PI / 2))
                        + E * d.dot(sun) * d.dot(sun);
                yield aboutSun * (1 + A * StrictMath.exp(B / Math.max(1e-6, height)));
            }
            default -> 1;
        };
    }

    /** A point with its normal and the directions in which it sees the sky. */
    private final class Place {

        private final Vec3 n;
        private final Vec3 u;
        private final Vec3 v;
        private final Predicate<Vec3> free;
        /** Components of the sky's zenith along u, v and n. */
        private final double[] up;
        /** Side of the smallest parts. */
        private int least;

        Place(Vec3 n, Predicate<Vec3> free) {
            this.n = n;
            this.free = free;
            u = n.perpendicular();
            v = n.cross(u);
            up = new double[] {u.dot(light.up()), v.dot(light.up()), n.dot(light.up())};
        }

        /** Mean over the circle of the luminance that the point sees. */
        double all() {
            int corners = SIDE + 1;
            double[] seen = new double[corners * corners];
            for (int i = 0; i < seen.length; i++) {
                seen[i] = at(CORNERS, 3 * i);
            }
            least = least(seen);
            double sum = 0;
            for (int row = 0; row < SIDE; row++) {
                for (int column = 0; column < SIDE; column++) {
                    int i = row * corners + column;
                    sum += cell(row * PARTS, column * PARTS, PARTS, seen[i], seen[i + 1], seen[i + corners],
                            seen[i + corners + 1]);
                }
            }
            return sum / (SIDE * SIDE);
        }

        /**
         * Side of parts so small that those on edges leave {@link #UNCERTAIN}: each half its luminance, the errors of
         * any two independent. Half the side makes twice as many of them.
         *
         * @param seen luminances at the corners of all cells
         */
        private int least(double[] seen) {
            int corners = SIDE + 1;
            int free = 0;
            int edges = 0;
            for (int i = 0; i < corners * SIDE; i++) {
                free += seen[i] > 0 ? 1 : 0;
                boolean isLast = i % corners == SIDE;
                edges += isLast || seen[i] > 0 == seen[i + 1] > 0 && seen[i] > 0 == seen[i + corners] > 0 ? 0 : 1;
            }
            int size = free == 0 ? 1 : PARTS / 2;
            while (size > 1 && Math.sqrt((double) edges * PARTS / size) * size * size / (2 * PARTS * PARTS)
                    > UNCERTAIN * free) {
                size /= 2;
            }
            return size;
        }

        /** Mean luminance over a cell with first corner at row and column; a to d are the luminances at its corners. */
        private double cell(int row, int column, int size, double a, double b, double c, double d) {
            double mean = (a + b + c + d) / 4;
            boolean isAlike = mean == 0 || a > 0 && b > 0 && c > 0 && d > 0;
            if (isAlike && size < PARTS) {
                return mean;
            }
            if (!isAlike && isBelowHorizon(row, column, size)) {
                return 0;
            }
            if (size == least) {
                long key = Hash.mix(row, column);
                return at(row + size * Hash.unit(Hash.mix(key, 0)), column + size * Hash.unit(Hash.mix(key, 1)));
            }
            int half = size / 2;
            double middle = at(row + half, column + half);
            if (isAlike && middle > 0 == mean > 0) {
                // exact where luminance is a square polynomial: on a line the same as Simpson's rule
                return (mean + 2 * middle) / 3;
            }
            double above = at(row, column + half);
            double left = at(row + half, column);
            double right = at(row + half, column + size);
            double below = at(row + size, column + half);
            return (cell(row, column, half, a, above, left, middle)
                    + cell(row, column + half, half, above, b, middle, right)
                    + cell(row + half, column, half, left, middle, c, below)
                    + cell(row + half, column + half, half, middle, right, below, d)) / 4;
        }

        /** Whether no corner of a cell is above the horizon, though some may be on it, which count as sky. */
        private boolean isBelowHorizon(int row, int column, int size) {
            return height(row, column) <= LEVEL && height(row, column + size) <= LEVEL
                    && height(row + size, column) <= LEVEL && height(row + size, column + size) <= LEVEL;
        }

        private double height(int row, int column) {
            return height(direction(row, column), 0);
        }

        private double height(double[] local, int from) {
            return local[from] * up[0] + local[from + 1] * up[1] + local[from + 2] * up[2];
        }

        private double at(double row, double column) {
            return at(direction(row, column), 0);
        }

        /** Luminance that the point sees in a direction: 3 components from {@code from}, as in {@link #CORNERS}. */
        private double at(double[] local, int from) {
            double height = height(local, from);
            if (height < -LEVEL) {
                return 0;
            }
            Vec3 d = u.times(local[from]).plus(v.times(local[from + 1])).plus(n.times(local[from + 2]));
            return free.test(d) ? luminance(d, height) : 0;
        }
    }
}
