package radiosity.worker;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.mesh.PatchTree;
import radiosity.protocol.Shot;

class ShotHistoryTest {

    private static final int[] FOUR_PARTS = {1, -1, -1, -1, -1};

    private static Shot shot(double a, double b, double c) {
        return new Shot(List.of(new PatchTree(7, 1, new int[] {-1}, new double[] {a, b, c})), 0);
    }

    /**
     * Partitions add each shot at the corners of the elements that there are when it is shot. A sum of shots that is
     * divided afterwards is rounded otherwise, so a shooter is kept as it is divided even before it has shot.
     */
    @Test
    void shooterThatIsDividedBeforeItShoots_hasTheBitsOfItsElements() {
        Shot elements = new Shot(List.of(new PatchTree(7, 1, FOUR_PARTS, new double[0])), 0);
        Shot once = shot(0.1, 0.2, 0.7);
        Shot again = shot(1e-17, 0.3, 1e17);
        ShotHistory history = new ShotHistory(1);
        history.of(elements);
        assertFalse(history.isEmpty());
        history.add(List.of(once));
        history.add(List.of(again));
        double[] first = once.trees().get(0).divided(FOUR_PARTS).radiosity();
        double[] second = again.trees().get(0).divided(FOUR_PARTS).radiosity();
        double[] sum = new double[first.length];
        for (int i = 0; i < sum.length; i++) {
            sum[i] = first[i] + second[i];
        }
        assertArrayEquals(sum, history.of(elements).trees().get(0).radiosity());
    }
}
