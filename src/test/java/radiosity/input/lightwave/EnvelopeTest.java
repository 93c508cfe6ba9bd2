package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import radiosity.input.lightwave.lws.Envelope;
import radiosity.input.lightwave.lws.EnvelopeCurve;

/** Envelopes against closed forms of their curves. */
class EnvelopeTest {

    private static final double EXACT = 1e-12;

    /** Keys of (value, time, span, parameters...). */
    private static Envelope envelope(int before, int after, double[]... keys) {
        Envelope envelope = new Envelope();
        for (double[] key : keys) {
            envelope.add(key);
        }
        envelope.behaviours(before, after);
        return envelope;
    }

    private static double at(Envelope envelope, double time) {
        return EnvelopeCurve.at(envelope, time, 99);
    }

    @Test
    void noKeys_giveTheDefault() {
        assertEquals(99, at(new Envelope(), 0));
        assertEquals(99, EnvelopeCurve.at(null, 0, 99));
    }

    @Test
    void oneKey_isConstant() {
        Envelope one = envelope(0, 0, new double[] {7, 3});
        assertEquals(7, at(one, -100));
        assertEquals(7, at(one, 100));
    }

    @Test
    void linearSpan_isALine() {
        Envelope line = envelope(1, 1, new double[] {1, 0, 3}, new double[] {3, 4, 3});
        assertEquals(1.5, at(line, 1), EXACT);
        assertEquals(3, at(line, 4), EXACT);
    }

    @Test
    void steppedSpan_keepsTheKeyBefore() {
        Envelope steps = envelope(1, 1, new double[] {1, 0, 4}, new double[] {3, 4, 4});
        assertEquals(1, at(steps, 3.999), EXACT);
        assertEquals(3, at(steps, 4), EXACT);
    }

    @Test
    void neutralTcbSpan_isACatmullRomSpline() {
        Envelope spline = envelope(1, 1, new double[] {0, 0, 0}, new double[] {1, 1, 0}, new double[] {4, 2, 0},
                new double[] {9, 3, 0});
        for (double t = 1; t <= 2; t += 0.125) {
            assertEquals(t * t, at(spline, t), EXACT, "a parabola through its own points at " + t);
        }
    }

    @Test
    void fullTension_givesFlatKeys() {
        Envelope tense = envelope(1, 1, new double[] {0, 0, 0, 1}, new double[] {1, 1, 0, 1},
                new double[] {0, 2, 0, 1});
        double t = 0.25;
        assertEquals(3 * t * t - 2 * t * t * t, at(tense, t), EXACT);
    }

    @Test
    void hermiteSpan_hasTheTangentsOfItsKeys() {
        Envelope hermite = envelope(1, 1, new double[] {0, 0, 1, 0, 0, 0, 0, 2},
                new double[] {1, 1, 1, 0, 0, 0, -3, 0});
        double t = 0.5;
        double expected = 3 * t * t - 2 * t * t * t + 2 * (t * t * t - 2 * t * t + t) - 3 * (t * t * t - t * t);
        assertEquals(expected, at(hermite, t), EXACT);
    }

    @Test
    void bezierSpan_withHandlesOnTheLine_isTheLine() {
        Envelope bezier = envelope(1, 1, new double[] {0, 0, 5, 0, 0, 1, 2}, new double[] {6, 3, 5, -1, -2});
        assertEquals(2.5, at(bezier, 1.25), 1e-9);
    }

    /** Before it the curve goes on at the mean of both slopes, 13.5: a third of that is the height of the handle. */
    @Test
    void bezierSpanAfterALinearKey_beginsAlongItsTangent() {
        Envelope mixed = envelope(1, 1, new double[] {-18, -1, 3}, new double[] {0, 0, 3},
                new double[] {9, 1, 5, -1.0 / 3, 0});
        assertEquals(4.5 + 3 * 4.5 / 8, at(mixed, .5), 1e-9);
    }

    @Test
    void bezierSpan_meetsItsOwnCurve() {
        Envelope bezier = envelope(1, 1, new double[] {0, 0, 5, 0, 0, 0.5, 0}, new double[] {1, 1, 5, -0.25, 0});
        double t = 0.3;
        double time = 3 * (1 - t) * (1 - t) * t * 0.5 + 3 * (1 - t) * t * t * 0.75 + t * t * t;
        double value = 3 * (1 - t) * t * t + t * t * t;
        assertEquals(value, at(bezier, time), 1e-9);
    }

    @Test
    void behaviours_holdOutsideTheKeys() {
        double[][] keys = {{1, 10, 3}, {3, 12, 3}};
        assertEquals(0, at(envelope(0, 0, keys), 0), EXACT);
        assertEquals(1, at(envelope(1, 1, keys), 0), EXACT);
        assertEquals(3, at(envelope(1, 1, keys), 50), EXACT);
        assertEquals(1.5, at(envelope(2, 2, keys), 14.5), EXACT);
        assertEquals(2.5, at(envelope(2, 2, keys), 9.5), EXACT);
        assertEquals(2.5, at(envelope(3, 3, keys), 12.5), EXACT);
        assertEquals(1.5, at(envelope(3, 3, keys), 9.5), EXACT);
        assertEquals(3.5, at(envelope(4, 4, keys), 12.5), EXACT);
        assertEquals(0.5, at(envelope(4, 4, keys), 9.5), EXACT);
        assertEquals(5, at(envelope(5, 5, keys), 14), EXACT);
        assertEquals(-9, at(envelope(5, 5, keys), 0), EXACT);
    }

    @Test
    void unboundedTimes_areFinite() {
        Envelope repeated = envelope(2, 4, new double[] {1, 0, 0}, new double[] {2, 1, 0});
        assertEquals(true, Double.isFinite(at(repeated, 1e300)));
        assertEquals(true, Double.isFinite(at(repeated, -1e300)));
        assertEquals(1, at(repeated, Double.NEGATIVE_INFINITY));
    }
}
