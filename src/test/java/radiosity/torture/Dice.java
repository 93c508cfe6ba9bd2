package radiosity.torture;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** Random numbers that follow from a seed alone. */
final class Dice {

    private final Random random;

    Dice(long seed) {
        random = new Random(mixed(seed));
    }

    /** Neighbouring seeds give unrelated numbers (the finalizer of SplitMix64). */
    static long mixed(long seed) {
        long z = seed * 0x9E3779B97F4A7C15L + 0x1234567;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }

    boolean chance(double probability) {
        return random.nextDouble() < probability;
    }

    /** From {@code from} to {@code to}, both included. */
    int integer(int from, int to) {
        return from + random.nextInt(to - from + 1);
    }

    double between(double from, double to) {
        return from + (to - from) * random.nextDouble();
    }

    /** Evenly distributed in its logarithm; both limits are positive. */
    double logarithmic(double from, double to) {
        return from * StrictMath.pow(to / from, random.nextDouble());
    }

    @SafeVarargs
    final <T> T of(T... values) {
        return values[random.nextInt(values.length)];
    }

    <T> List<T> shuffled(List<T> values) {
        List<T> copy = new ArrayList<>(values);
        Collections.shuffle(copy, random);
        return copy;
    }
}
