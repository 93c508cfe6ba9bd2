package radiosity.accuracy.reference;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/**
 * Radiosities at points by path tracing: every ray is compared with every rectangle, in double precision.
 *
 * <p>B = rho H, and H is the mean of the radiosities that are seen in directions with a density of cos / pi. Each path
 * is followed until less than 1e-5 of it would be reflected. At every point of a path the lamp is sampled in two ways,
 * at a random point of its area and by the path's next direction, weighted by the balance heuristic (E. Veach and L. J.
 * Guibas, Optimally combining sampling techniques for Monte Carlo rendering, 1995). The first numbers of each path are
 * a Richtmyer sequence, multiples of square roots of primes modulo 1 (R. D. Richtmyer, The evaluation of definite
 * integrals, and a quasi-Monte-Carlo method, 1951), with a random shift per batch of paths; the others are random. The
 * batches are independent of each other, so their spread gives the standard error of their mean.
 */
final class PathTracer {

    private static final int BATCHES = 32;
    private static final double LEAST_WEIGHT = 1e-5;
    private static final double[] STEPS = {Math.sqrt(2), Math.sqrt(3), Math.sqrt(5), Math.sqrt(7), Math.sqrt(11),
        Math.sqrt(13), Math.sqrt(17), Math.sqrt(19)};

    /** Values per rectangle in {@link #planes}: its plane, and its edges as parts; of each x, y, z and a constant. */
    private static final int STRIDE = 12;

    private final List<Rectangle> rectangles;
    private final double[][] normal;
    private final double[] planes;
    private final int lamp;
    private final double lampArea;
    private final double[] exitance;

    /** @param room with exactly one rectangle that emits */
    PathTracer(Room room) {
        rectangles = room.rectangles();
        normal = new double[rectangles.size()][];
        planes = new double[STRIDE * rectangles.size()];
        int[] lamps = IntStream.range(0, normal.length).filter(i -> rectangles.get(i).material().emits()).toArray();
        if (lamps.length != 1) {
            throw new IllegalArgumentException("room " + room.name() + ": expected one lamp, got " + lamps.length);
        }
        lamp = lamps[0];
        lampArea = rectangles.get(lamp).area();
        exitance = rectangles.get(lamp).material().exitance();
        for (int i = 0; i < normal.length; i++) {
            Rectangle r = rectangles.get(i);
            normal[i] = r.normal();
            put(STRIDE * i, normal[i], 1, r.origin());
            put(STRIDE * i + 4, r.u(), Rectangle.dot(r.u(), r.u()), r.origin());
            put(STRIDE * i + 8, r.v(), Rectangle.dot(r.v(), r.v()), r.origin());
        }
    }

    /** Writes the function that is 0 at the origin and grows along a vector. */
    private void put(int to, double[] vector, double divisor, double[] origin) {
        for (int k = 0; k < 3; k++) {
            planes[to + k] = vector[k] / divisor;
        }
        planes[to + 3] = -Rectangle.dot(vector, origin) / divisor;
    }

    /**
     * Reflected radiosity at a point: of red, green, blue, and of the mean of these colours.
     *
     * @param mean          4 values, W/m²
     * @param standardError of the mean; 4 values, W/m²
     * @param paths         number of paths in all batches together
     */
    record Estimate(double[] mean, double[] standardError, long paths) {

        /** Standard error of the mean of the colours, relative to that mean. */
        double noise() {
            return standardError[3] / mean[3];
        }
    }

    /**
     * Doubles the number of paths until the standard error is small enough.
     *
     * @param fewest paths of the first look, in all batches together
     * @param most   number of paths that is never exceeded after the first look
     * @param noise  largest {@link Estimate#noise} that is accepted
     */
    Estimate estimate(Room.Place place, long seed, long fewest, long most, double noise) {
        Batch[] batches = new Batch[BATCHES];
        SplittableRandom seeds = new SplittableRandom(seed);
        for (int i = 0; i < BATCHES; i++) {
            batches[i] = new Batch(place, seeds.split());
        }
        long paths = Math.max(1, fewest / BATCHES);
        while (true) {
            for (Batch batch : batches) {
                batch.traceUntil(paths);
            }
            Estimate found = estimate(batches);
            if (found.noise() <= noise || 2 * found.paths() > most) {
                return found;
            }
            paths *= 2;
        }
    }

    private static Estimate estimate(Batch[] batches) {
        double[] mean = new double[4];
        double[] error = new double[4];
        for (int c = 0; c < 4; c++) {
            for (Batch batch : batches) {
                mean[c] += batch.mean(c) / BATCHES;
            }
            double squares = 0;
            for (Batch batch : batches) {
                double d = batch.mean(c) - mean[c];
                squares += d * d;
            }
            error[c] = Math.sqrt(squares / (BATCHES - 1) / BATCHES);
        }
        return new Estimate(mean, error, BATCHES * batches[0].paths);
    }

    /** Whether the point lies inside a block: what is first in the direction of its normal is seen from behind. */
    boolean isBuried(int on, double[] position) {
        double[] distance = new double[1];
        nearest(on, position, normal[on], 1, distance);
        double front = distance[0];
        nearest(on, position, normal[on], -1, distance);
        return distance[0] < front;
    }

    /**
     * The rectangle that a ray meets first.
     *
     * @param on       index of the rectangle on which the ray begins
     * @param side     1 for rectangles that show their visible side to the ray, -1 for the others
     * @param distance receives the distance along the ray; infinite where nothing is met
     * @return -1 where nothing is met
     */
    private int nearest(int on, double[] from, double[] direction, int side, double[] distance) {
        int first = -1;
        distance[0] = Double.POSITIVE_INFINITY;
        for (int i = 0; i < normal.length; i++) {
            double t = i == on ? Double.POSITIVE_INFINITY : distance(i, from, direction, side);
            if (t < distance[0]) {
                distance[0] = t;
                first = i;
            }
        }
        return first;
    }

    /** Distance along a ray, in lengths of its direction; infinite where the rectangle is missed. */
    private double distance(int i, double[] from, double[] direction, int side) {
        int p = STRIDE * i;
        double approach = planes[p] * direction[0] + planes[p + 1] * direction[1] + planes[p + 2] * direction[2];
        if (side * approach >= 0) {
            return Double.POSITIVE_INFINITY;
        }
        double t = -value(p, from[0], from[1], from[2]) / approach;
        if (t <= 0) {
            return Double.POSITIVE_INFINITY;
        }
        double x = from[0] + t * direction[0];
        double y = from[1] + t * direction[1];
        double z = from[2] + t * direction[2];
        double u = value(p + 4, x, y, z);
        double v = value(p + 8, x, y, z);
        return u >= 0 && u <= 1 && v >= 0 && v <= 1 ? t : Double.POSITIVE_INFINITY;
    }

    private double value(int p, double x, double y, double z) {
        return planes[p] * x + planes[p + 1] * y + planes[p + 2] * z + planes[p + 3];
    }

    /** Paths from one point that share a random shift. */
    private final class Batch {

        private final Room.Place place;
        private final SplittableRandom random;
        private final double[] shift = new double[STEPS.length];
        private final double[] sum = new double[3];
        private long paths;
        /** Numbers that the path under way has drawn. */
        private int drawn;
        private final double[] at = new double[3];
        private final double[] direction = new double[3];
        private final double[] distance = new double[1];
        private final double[] weight = new double[3];

        Batch(Room.Place place, SplittableRandom random) {
            this.place = place;
            this.random = random;
            for (int i = 0; i < shift.length; i++) {
                shift[i] = random.nextDouble();
            }
        }

        void traceUntil(long count) {
            for (; paths < count; paths++) {
                path();
            }
        }

        /** @param c 0 to 2 for a channel, 3 for the mean of the channels */
        double mean(int c) {
            return (c < 3 ? sum[c] : (sum[0] + sum[1] + sum[2]) / 3) / paths;
        }

        private double draw() {
            int i = drawn++;
            return i < STEPS.length ? (shift[i] + paths * STEPS[i]) % 1 : random.nextDouble();
        }

        private void path() {
            drawn = 0;
            int on = place.on();
            System.arraycopy(place.position(), 0, at, 0, 3);
            System.arraycopy(rectangles.get(on).material().reflectance(), 0, weight, 0, 3);
            while (Math.max(weight[0], Math.max(weight[1], weight[2])) > LEAST_WEIGHT) {
                addLight(on);
                drawDirection(normal[on]);
                int hit = nearest(on, at, direction, 1, distance);
                if (hit < 0) {
                    throw new IllegalStateException("a ray has left the room at " + Arrays.toString(at));
                }
                double cosine = Rectangle.dot(normal[on], direction);
                for (int i = 0; i < 3; i++) {
                    at[i] += distance[0] * direction[i];
                }
                if (hit == lamp) {
                    double there = -Rectangle.dot(normal[lamp], direction);
                    double density = cosine * there / (Math.PI * distance[0] * distance[0]);
                    add(density / (density + 1 / lampArea));
                }
                double[] reflectance = rectangles.get(hit).material().reflectance();
                for (int c = 0; c < 3; c++) {
                    weight[c] *= reflectance[c];
                }
                on = hit;
            }
        }

        private void add(double part) {
            for (int c = 0; c < 3; c++) {
                sum[c] += weight[c] * exitance[c] * part;
            }
        }

        /** Adds what a random point of the lamp sends to the end of the path, where nothing is between them. */
        private void addLight(int on) {
            double[] to = rectangles.get(lamp).at(draw(), draw());
            double[] ray = {to[0] - at[0], to[1] - at[1], to[2] - at[2]};
            double square = Rectangle.dot(ray, ray);
            double here = Rectangle.dot(normal[on], ray);
            double there = -Rectangle.dot(normal[lamp], ray);
            if (on != lamp && here > 0 && there > 0 && isFree(on, ray)) {
                double density = here * there / (Math.PI * square * square);
                add(density / (density + 1 / lampArea));
            }
        }

        private boolean isFree(int on, double[] ray) {
            for (int i = 0; i < normal.length; i++) {
                if (i != on && i != lamp && distance(i, at, ray, 1) < 1) {
                    return false;
                }
            }
            return true;
        }

        /** Draws a direction with a density of cos / pi: the normal plus a uniform point of the unit sphere. */
        private void drawDirection(double[] n) {
            double cosine = 2 * draw() - 1;
            double angle = 2 * Math.PI * draw();
            double sine = Math.sqrt(1 - cosine * cosine);
            direction[0] = n[0] + sine * Math.cos(angle);
            direction[1] = n[1] + sine * Math.sin(angle);
            direction[2] = n[2] + cosine;
            double length = Math.sqrt(Rectangle.dot(direction, direction));
            for (int i = 0; i < 3; i++) {
                direction[i] /= length;
            }
        }
    }
}
