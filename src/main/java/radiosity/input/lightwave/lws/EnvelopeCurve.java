package radiosity.input.lightwave.lws;

/**
 * Evaluates an envelope at a time.
 *
 * <p>Source: the LightWave software development kit (NewTek), whose documents give these formulas for the tangents of
 * Kochanek-Bartels, Hermite and linear keys and for two-dimensional Bezier curves.
 */
public final class EnvelopeCurve {

    private static final int HALVINGS = 60;

    private final Envelope keys;
    private final int last;

    private EnvelopeCurve(Envelope keys) {
        this.keys = keys;
        this.last = keys.size() - 1;
    }

    /**
     * Value of an envelope; the first key's value where the curve has no finite value.
     *
     * @param keys  null counts as an envelope without keys
     * @param time  in the unit of the envelope's keys; negative infinity stands for the time of the first key
     * @param empty the value of an envelope without keys
     */
    public static double at(Envelope keys, double time, double empty) {
        if (keys == null || keys.size() == 0) {
            return empty;
        }
        if (keys.size() == 1 || time == Double.NEGATIVE_INFINITY) {
            return keys.value(0);
        }
        double value = new EnvelopeCurve(keys).at(time);
        return Double.isFinite(value) ? value : keys.value(0);
    }

    private double at(double time) {
        if (time < keys.time(0)) {
            return outside(time, keys.before(), 0);
        }
        if (time > keys.time(last)) {
            return outside(time, keys.after(), last);
        }
        return inside(time);
    }

    private double outside(double time, int behaviour, int end) {
        double start = keys.time(0);
        double length = keys.time(last) - start;
        if (behaviour >= 2 && behaviour <= 4 && length > 0) {
            double turns = Math.floor((time - start) / length);
            double within = Math.min(length, Math.max(0, time - start - turns * length));
            boolean back = behaviour == 3 && Math.abs(turns % 2) == 1;
            double offset = behaviour == 4 ? turns * (keys.value(last) - keys.value(0)) : 0;
            return inside(start + (back ? length - within : within)) + offset;
        }
        return switch (behaviour) {
            case 0 -> 0;
            case 5 -> keys.value(end) + slope(end) * (time - keys.time(end));
            default -> keys.value(end);
        };
    }

    private double slope(int end) {
        int a = end == 0 ? 0 : last - 1;
        double length = keys.time(a + 1) - keys.time(a);
        return (end == 0 ? outgoing(a) : incoming(a)) / length;
    }

    private double inside(double time) {
        int a = spanAt(time);
        double t = (time - keys.time(a)) / (keys.time(a + 1) - keys.time(a));
        if (!(t > 0)) {
            return keys.value(a);
        }
        if (t >= 1) {
            return keys.value(a + 1);
        }
        return switch (keys.span(a + 1)) {
            case Envelope.LINEAR -> keys.value(a) + t * (keys.value(a + 1) - keys.value(a));
            case Envelope.STEPPED -> keys.value(a);
            case Envelope.BEZIER -> bezier(a, time);
            default -> hermite(a, t);
        };
    }

    /** First key of the first span that ends at or after a time; if none does, first key of the last span. */
    private int spanAt(double time) {
        int a = 0;
        while (a < last - 1 && time > keys.time(a + 1)) {
            a++;
        }
        return a;
    }

    private double hermite(int a, double t) {
        double t2 = t * t;
        double t3 = t2 * t;
        return (2 * t3 - 3 * t2 + 1) * keys.value(a) + (3 * t2 - 2 * t3) * keys.value(a + 1)
                + (t3 - 2 * t2 + t) * outgoing(a) + (t3 - t2) * incoming(a);
    }

    /** Tangent at the first key of a span, multiplied by the span's length. */
    private double outgoing(int a) {
        double rise = keys.value(a + 1) - keys.value(a);
        double earlier = a == 0 ? 0 : keys.value(a) - keys.value(a - 1);
        double share = a == 0 ? 1 : (keys.time(a + 1) - keys.time(a)) / (keys.time(a + 1) - keys.time(a - 1));
        return switch (keys.span(a)) {
            case Envelope.TCB -> share * (tcb(a, 1, 1) * earlier + tcb(a, -1, -1) * rise);
            case Envelope.LINEAR -> share * (earlier + rise);
            case Envelope.HERMITE, Envelope.OLD_BEZIER -> share * keys.parameter(a, 4);
            case Envelope.BEZIER -> steepness(keys.parameter(a, 3), keys.parameter(a, 2), a);
            default -> 0;
        };
    }

    /** Tangent at the second key of a span, multiplied by the span's length. */
    private double incoming(int a) {
        int b = a + 1;
        double rise = keys.value(b) - keys.value(a);
        double later = b == last ? 0 : keys.value(b + 1) - keys.value(b);
        double share = b == last ? 1 : (keys.time(b) - keys.time(a)) / (keys.time(b + 1) - keys.time(a));
        return switch (keys.span(b)) {
            case Envelope.TCB -> share * (tcb(b, 1, -1) * later + tcb(b, -1, 1) * rise);
            case Envelope.LINEAR -> share * (later + rise);
            case Envelope.HERMITE, Envelope.OLD_BEZIER -> share * keys.parameter(b, 3);
            case Envelope.BEZIER -> steepness(keys.parameter(b, 1), keys.parameter(b, 0), a);
            default -> 0;
        };
    }

    /** (1 - tension) (1 +- continuity) (1 +- bias), with the signs given by the arguments 1 and -1. */
    private double tcb(int key, int continuity, int bias) {
        return (1 - keys.parameter(key, 0)) * (1 + continuity * keys.parameter(key, 1))
                * (1 + bias * keys.parameter(key, 2));
    }

    private double steepness(double rise, double run, int a) {
        double length = keys.time(a + 1) - keys.time(a);
        return rise * length / (Math.abs(run) > 1e-5 ? run : 1e-5);
    }

    /**
     * A Bezier curve in time and value between two keys; its parameter at the time is found by bisection. A first
     * key that is not Bezier has its handle at a third of the span, along its tangent.
     */
    private double bezier(int a, double time) {
        int b = a + 1;
        boolean isBezier = keys.span(a) == Envelope.BEZIER;
        double firstTime = isBezier ? keys.parameter(a, 2) : (keys.time(b) - keys.time(a)) / 3;
        double firstValue = isBezier ? keys.parameter(a, 3) : outgoing(a) / 3;
        double lastTime = keys.time(b) + keys.parameter(b, 0);
        double lastValue = keys.value(b) + keys.parameter(b, 1);
        double from = 0;
        double to = 1;
        for (int i = 0; i < HALVINGS; i++) {
            double t = (from + to) / 2;
            double here = cubic(t, keys.time(a), keys.time(a) + firstTime, lastTime, keys.time(b));
            if (here < time) {
                from = t;
            } else {
                to = t;
            }
        }
        return cubic(from, keys.value(a), keys.value(a) + firstValue, lastValue, keys.value(b));
    }

    private static double cubic(double t, double p0, double p1, double p2, double p3) {
        double s = 1 - t;
        return s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3;
    }
}
