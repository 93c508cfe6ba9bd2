package radiosity.util;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ExactSumTest {

    private static ExactSum sum(double... terms) {
        ExactSum sum = new ExactSum(1);
        for (double term : terms) {
            sum.add(term);
        }
        return sum;
    }

    private static ExactSum decoded(ExactSum sum) {
        return new ExactSum(1).with(sum.high(), sum.low());
    }

    private static ExactSum added(ExactSum sum, ExactSum other) {
        sum.add(other);
        return sum;
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void sumWithATermThatIsNoNumber_isNaN(double term) {
        assertEquals(Double.NaN, sum(1, term, 1).value());
        assertEquals(Double.NaN, decoded(sum(1, term, 1)).value());
        assertEquals(Double.NaN, added(sum(1), sum(term)).value());
        assertEquals(Double.NaN, added(sum(term), sum(1)).value());
        assertEquals(Double.NaN, added(decoded(sum(term)), decoded(sum(term))).value());
        assertEquals(Double.NaN, decoded(added(sum(1), decoded(sum(term)))).value());
    }

    @Test
    void sumOfNumbers_hasTheSameBitsInEveryOrderAndOverTheWire() {
        double[] terms = new Random(1).doubles(1000, -1, 1).toArray();
        ExactSum forward = new ExactSum(1);
        ExactSum backward = new ExactSum(1);
        double plain = 0;
        for (int i = 0; i < terms.length; i++) {
            forward.add(terms[i]);
            backward.add(terms[terms.length - 1 - i]);
            plain += terms[i];
        }
        assertEquals(forward.high(), backward.high());
        assertEquals(forward.low(), backward.low());
        assertEquals(forward.value(), decoded(forward).value());
        assertEquals(plain, forward.value(), 1e-12);
    }

    @Test
    void encodingOfNumbers_isTheTwoWholeNumbers() {
        assertEquals(1L << 35, sum(1).high());
        assertEquals(0, sum(1).low());
        assertEquals(-1, sum(-0x1p-70).high());
        assertEquals((1L << 35) - 1, sum(-0x1p-70).low());
    }
}
