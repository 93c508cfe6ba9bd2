package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.Radiosity;
import radiosity.output.gltf.LitScene;

class FollowedFileTest {

    @TempDir
    Path folder;

    @Test
    void fileThatCannotBeRead_isToldAndTheNextOneIsShown() throws Exception {
        Path file = Files.writeString(folder.resolve("room.scene"), "1");
        LitScene scene = LitScene.unlit(Radiosity.read(Path.of("scenes/cornell-box.lws"), line -> { }));
        AtomicInteger reads = new AtomicInteger();
        BlockingQueue<Object> got = new LinkedBlockingQueue<>();
        FollowedFile followed = new FollowedFile(file, () -> switch (reads.incrementAndGet()) {
            case 1 -> throw new OutOfMemoryError("Java heap space");
            case 2 -> throw new IllegalStateException("no such mesh");
            default -> scene;
        }, got::add, got::add);
        followed.start();
        try {
            Files.writeString(file, "22");
            assertEquals("not read again: Java heap space", got.poll(1, TimeUnit.MINUTES));
            Files.writeString(file, "333");
            assertEquals("not read again: no such mesh", got.poll(1, TimeUnit.MINUTES));
            Files.writeString(file, "4444");
            assertEquals(scene, got.poll(1, TimeUnit.MINUTES));
        } finally {
            followed.stop();
        }
    }
}
