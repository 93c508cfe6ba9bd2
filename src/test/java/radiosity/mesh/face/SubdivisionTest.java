package radiosity.mesh.face;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Children of a triangle. */
class SubdivisionTest {

    /** The child's corners with the child's weights give the point that the parent's give. */
    @Test
    void enteredChild_containsThePoint() {
        Random random = new Random(3);
        for (int i = 0; i < 1000; i++) {
            double u = random.nextDouble();
            double v = (1 - u) * random.nextDouble();
            double[] weights = {u, v, 1 - u - v};
            double[] expected = weights.clone();
            double[] corners = {1, 0, 0, 0, 1, 0, 0, 0, 1};
            double[] of = Subdivision.values(corners, 3, Subdivision.enter(weights));
            double[] point = new double[3];
            for (int k = 0; k < 9; k++) {
                assertTrue(weights[k / 3] >= 0 && weights[k / 3] <= 1, "weight " + weights[k / 3]);
                point[k % 3] += weights[k / 3] * of[k];
            }
            assertArrayEquals(expected, point, 1e-12);
        }
    }
}
