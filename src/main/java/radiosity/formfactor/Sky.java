package radiosity.formfactor;

import java.util.function.Predicate;
import radiosity.scene.Light;
import radiosity.scene.Vec3;

/**
 * The light of a sky, through openings of any shape.
 *
 * <p>Rays are uniform in the circle below a point's hemisphere (W. Nusselt, 1928), in square cells of angle and squared
 * radius. Where cells that see the sky and cells that do not meet, they are divided: an opening's edge is found to
 * 1/768 of the square's side. An opening smaller than a cell may be missed: one of 1 m from 27 m away.
 *
 * <p>Luminances: CIE S 011/E:2003, Spatial distribution of daylight - CIE standard general sky.
 */
final class Sky {

    private static final int SIDE = 48;
    private static final int DEEPEST = 4;
    /** Of the general sky of type 12. */
    private static final double A = -1;
    private static final double B = -0.32;
    private static final double C = 10;
    private static final double D = -3;
    private static final double E = 0.45;

    private final Light light;
    private final Vec3 sun;
    /** What makes the irradiance of a level place 1. */
    private final double scale;

    Sky(Light light) {
        this.light = light;
        sun = light.direction().unit().times(-1);
        scale = 1 / new Place(light.up(), d -> true).all();
    }

    /**
     * Irradiance where a level place in the open has 1.
     *
     * @param free whether nothing is in the way in a direction
     */
    double irradiance(Vec3 x, Vec3 n, Predicate<Vec3> free) {
        return scale * new Place(n, free).all();
    }

    /** Relative to the others. */
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

    /** A point, and what it sees. */
    private final class Place {

        private final Vec3 n;
        private final Vec3 u;
        private final Vec3 v;
        private final Predicate<Vec3> free;

        Place(Vec3 n, Predicate<Vec3> free) {
            this.n = n;
            this.free = free;
            u = n.cross(Math.abs(n.x()) < 0.6 ? new Vec3(1, 0, 0) : new Vec3(0, 1, 0)).unit();
            v = n.cross(u);
        }

        /** Mean luminance over the circle. */
        double all() {
            double[] seen = new double[SIDE * SIDE];
            for (int i = 0; i < seen.length; i++) {
                seen[i] = at((i / SIDE + 0.5) / SIDE, (i % SIDE + 0.5) / SIDE);
            }
            double sum = 0;
            for (int i = 0; i < seen.length; i++) {
                sum += isEdge(seen, i / SIDE, i % SIDE)
                        ? divided((double) (i / SIDE) / SIDE, (double) (i % SIDE) / SIDE, 1.0 / SIDE, 1) : seen[i];
            }
            return sum / seen.length;
        }

        private boolean isEdge(double[] seen, int row, int column) {
            boolean here = seen[row * SIDE + column] > 0;
            for (int r = Math.max(0, row - 1); r <= Math.min(SIDE - 1, row + 1); r++) {
                for (int c = column - 1; c <= column + 1; c++) {
                    if (seen[r * SIDE + (c + SIDE) % SIDE] > 0 != here) {
                        return true;
                    }
                }
            }
            return false;
        }

        /** Mean over a cell of which a corner and the size are given. */
        private double divided(double square, double turn, double size, int depth) {
            double[] seen = new double[4];
            int lit = 0;
            for (int k = 0; k < 4; k++) {
                seen[k] = at(square + size * (k / 2 + 0.5) / 2, turn + size * (k % 2 + 0.5) / 2);
                lit += seen[k] > 0 ? 1 : 0;
            }
            double sum = 0;
            for (int k = 0; k < 4; k++) {
                sum += depth == DEEPEST || lit == 0 || lit == 4 ? seen[k]
                        : divided(square + size * (k / 2) / 2, turn + size * (k % 2) / 2, size / 2, depth + 1);
            }
            return sum / 4;
        }

        /** @param square of the radius in the circle, 0 to 1; @param turn angle / (2 pi) */
        private double at(double square, double turn) {
            double r = Math.sqrt(square);
            double angle = 2 * Math.PI * turn;
            Vec3 d = u.times(r * StrictMath.cos(angle)).plus(v.times(r * StrictMath.sin(angle)))
                    .plus(n.times(Math.sqrt(1 - square)));
            double height = d.dot(light.up());
            return height > 0 && free.test(d) ? luminance(d, height) : 0;
        }
    }
}
