package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

class DisplayTest {

    /** A step asks for them at every key: it must not meet the failure again. */
    @Test
    void obstaclesThatCannotBeMade_areNoneAndToldOnceInPlainWords() {
        PrintStream err = System.err;
        ByteArrayOutputStream told = new ByteArrayOutputStream();
        System.setErr(new PrintStream(told, true));
        try {
            CompletableFuture<Optional<Obstacles>> obstacles = Display.orNothing(CompletableFuture.supplyAsync(() -> {
                throw new OutOfMemoryError("Java heap space");
            }));
            assertEquals(Optional.empty(), obstacles.join());
            assertEquals(Optional.empty(), obstacles.getNow(null));
        } finally {
            System.setErr(err);
        }
        assertEquals("viewer: expected memory for what is in the way, got Java heap space; walls let you through, and a"
                + " click tells nothing" + System.lineSeparator(), told.toString());
    }
}
