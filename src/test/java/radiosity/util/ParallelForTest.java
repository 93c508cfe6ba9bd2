package radiosity.util;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A parallel loop that the user may cancel. */
class ParallelForTest {

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void cancelled_endsBetweenTwoPieces(int threads) {
        AtomicInteger done = new AtomicInteger();
        AtomicInteger asked = new AtomicInteger();
        Thread caller = Thread.currentThread();
        ParallelFor loop = new ParallelFor(threads).cancelledUnless(() -> {
            assertEquals(caller, Thread.currentThread());
            return asked.incrementAndGet() < 3;
        });
        assertThrows(CancellationException.class, () -> loop.run(10_000_000, i -> done.incrementAndGet()));
        assertEquals(3, asked.get());
        assertTrue(done.get() >= 2 && done.get() < 10_000_000, "pieces done: " + done);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void notCancelled_doesAllPieces(int threads) {
        AtomicInteger done = new AtomicInteger();
        new ParallelFor(threads).cancelledUnless(() -> true).run(1000, i -> done.incrementAndGet());
        assertEquals(1000, done.get());
    }
}
