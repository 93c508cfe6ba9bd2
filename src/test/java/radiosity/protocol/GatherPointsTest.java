package radiosity.protocol;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.mesh.Block;

/** Points on their way to hosts. */
class GatherPointsTest {

    private static Order order(int... first) {
        GatherPoints points = new GatherPoints(new float[] {1, 2, 3, 4, 5, 6}, new int[] {7, 8}, new long[] {9, -10},
                new byte[] {0, 2}, new byte[] {3, 0}, first);
        return Order.plain(Order.Kind.GATHER_AT, new Order.Question.Irradiance(points));
    }

    @Test
    void order_arrivesWithItsPoints() throws IOException {
        Order read = Order.decode(order(0, 0, 2).encode());
        GatherPoints points = ((Order.Question.Irradiance) read.question()).points();
        assertArrayEquals(new float[] {1, 2, 3, 4, 5, 6}, points.place());
        assertArrayEquals(new int[] {7, 8}, points.face());
        assertArrayEquals(new long[] {9, -10}, points.key());
        assertArrayEquals(new byte[] {0, 2}, points.rays());
        assertArrayEquals(new byte[] {3, 0}, points.slack());
        assertTrue(read.isAnswered());
        assertEquals(0, read.most());
    }

    @Test
    void block_hasTheRangeOfPointsDealtToIt() {
        GatherPoints points = ((Order.Question.Irradiance) order(0, 1, 1, 2).question()).points();
        Block first = new Block(0, new int[] {0}, new long[] {1});
        Block none = new Block(1, new int[] {0}, new long[] {1});
        Block last = new Block(2, new int[] {0}, new long[] {1});
        assertArrayEquals(new int[] {0, 1}, points.of(List.of(first, none, last)));
        assertArrayEquals(new int[] {}, points.of(List.of(none)));
        assertArrayEquals(new int[] {1}, points.of(List.of(last)));
    }

    @ParameterizedTest
    @CsvSource({"-1,2", "1,0", "0,3"})
    void rangesOutsideThePoints_areRefused(int from, int to) {
        byte[] bytes = order(from, to).encode();
        assertThrows(IOException.class, () -> Order.decode(bytes));
    }
}
