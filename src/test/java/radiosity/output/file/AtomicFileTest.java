package radiosity.output.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import radiosity.output.gltf.Handmade;
import radiosity.output.gltf.SceneFile;
import radiosity.output.gltf.WrittenScene;
import radiosity.scene.Vec3;

/** A scene file is written wholly or not at all. */
class AtomicFileTest extends WrittenScene {

    @Test
    void failedWrite_leavesTheOldFileAndNothingElse() throws IOException {
        Files.writeString(file, "old");
        assertThrows(IOException.class, () -> AtomicFile.write(file, channel -> {
            channel.write(ByteBuffer.wrap(new byte[100]));
            throw new IOException("disk full");
        }));
        assertEquals("old", Files.readString(file));
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of(file), files.toList());
        }
    }

    @Test
    void whatIsNoFile_isNotReplaced() throws IOException {
        Files.createDirectory(file);
        assertThrows(IOException.class, () -> write(Handmade.litRoom(Vec3.ZERO).solution()));
        assertTrue(Files.isDirectory(file));
    }

    @Test
    void symbolicLink_isFollowed() throws IOException {
        Path target = Files.writeString(folder.resolve("target.scene"), "old");
        Files.createSymbolicLink(file, target);
        write(Handmade.litRoom(Vec3.ZERO).solution());
        assertTrue(Files.isSymbolicLink(file));
        assertTrue(Files.size(target) > 1000);
    }

    @Test
    void openFile_staysWhatItWas_whenItIsReplaced() throws IOException {
        write(Handmade.litRoom(Vec3.ZERO).solution());
        try (SceneFile scene = SceneFile.open(file)) {
            write(new Handmade().solution());
            assertFalse(scene.meshes().isEmpty());
        }
    }

    @Test
    void symbolicLinkToNoFileYet_isFollowed() throws IOException {
        Path directory = Files.createDirectory(folder.resolve("below"));
        Files.createSymbolicLink(file, Path.of("second link"));
        Files.createSymbolicLink(folder.resolve("second link"), Path.of("below/target.scene"));
        AtomicFile.write(file, new byte[3]);
        assertTrue(Files.isSymbolicLink(file));
        assertEquals(3, Files.size(directory.resolve("target.scene")));
    }

    @Test
    void filesBeingWritten_areLeftAloneByOtherWrites() throws IOException {
        AtomicFile.write(file, channel -> {
            AtomicFile.write(folder.resolve("other.scene"), new byte[1]);
            channel.write(ByteBuffer.wrap(new byte[2]));
        });
        assertEquals(2, Files.size(file));
    }
}
