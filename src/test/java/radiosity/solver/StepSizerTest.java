package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import radiosity.protocol.Order;

/** Steps are bounded in the work that they hold, whatever the shots of a round cost. */
class StepSizerTest {

    private static final int SHOTS = 5000;

    /** Longest step and number of steps of a round whose shots take so long, s. */
    private static double[] round(StepSizer pace, int elements, IntToDoubleFunction cost) {
        double longest = 0;
        int steps = 0;
        for (int done = 0; done < SHOTS; steps++) {
            int size = pace.size(Order.Kind.SHOOT, elements, SHOTS - done);
            double seconds = 0;
            for (int i = done; i < done + size; i++) {
                seconds += cost.applyAsDouble(i);
            }
            pace.took(size, seconds);
            longest = Math.max(longest, seconds);
            done += size;
        }
        return new double[] {longest, steps};
    }

    @Test
    void equalShots_fillSteps() {
        double[] found = round(new StepSizer(StepSizer.STEP_SECONDS), 1, i -> 1e-3);
        assertTrue(found[0] <= StepSizer.STEP_SECONDS, "longest " + found[0]);
        assertTrue(found[1] < 1.5 * SHOTS * 1e-3 / StepSizer.STEP_SECONDS, "steps " + found[1]);
    }

    @Test
    void slowShotsAmongFastOnes_areNotForgotten() {
        double[] found = round(new StepSizer(StepSizer.STEP_SECONDS), 1, i -> i / 100 % 2 == 0 ? 1e-3 : 5e-3);
        assertTrue(found[0] <= 5 * StepSizer.STEP_SECONDS, "longest " + found[0]);
    }

    @Test
    void slowShots_areDoneOneByOne() {
        assertEquals(2, round(new StepSizer(StepSizer.STEP_SECONDS), 1, i -> 2)[0]);
    }

    @Test
    void moreElements_takeLonger() {
        StepSizer pace = new StepSizer(StepSizer.STEP_SECONDS);
        round(pace, 1, i -> 1e-6);
        assertTrue(round(pace, 1000, i -> 1e-3)[0] <= StepSizer.STEP_SECONDS);
    }

    @Test
    void afterARest_oneShotIsDoneAlone() {
        StepSizer pace = new StepSizer(StepSizer.STEP_SECONDS);
        round(pace, 1, i -> 1e-3);
        assertTrue(pace.size(Order.Kind.SHOOT, 1, SHOTS) > 1);
        pace.rest();
        assertEquals(1, pace.size(Order.Kind.SHOOT, 1, SHOTS));
    }

    @Test
    void roundWithoutShots_isOneStep() {
        assertEquals(1, new StepSizer(StepSizer.STEP_SECONDS).size(Order.Kind.SPLIT, 0, 0));
    }
}
