package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.viewer.Rendered.SIZE;
import static radiosity.viewer.Rendered.difference;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.Radiosity;
import radiosity.cli.RadiosityRenderer;
import radiosity.cli.render.SceneSource;
import radiosity.output.gltf.LitScene;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/** The tall block of the Cornell box is dragged about in the window, and its light follows. */
@Tag("slow")
class EditWindowTest {

    /** On the block; pixels. */
    private static final int X = SIZE * 2 / 5;
    private static final int MIDDLE = SIZE / 2;

    @TempDir
    Path folder;

    private Path rendered() throws IOException {
        for (String file : new String[] {"cornell-box.lws", "cornell-box.lwo"}) {
            Files.copy(Path.of("scenes", file), folder.resolve(file));
        }
        Path scene = folder.resolve("box.scene");
        assertEquals(0, RadiosityRenderer.run("-q", "--accuracy", "10%", folder.resolve("cornell-box.lws").toString(),
                scene.toString()));
        return scene;
    }

    private static String until(DrivenWindow window, String text) throws Exception {
        String status = "";
        for (int look = 0; look < 1200 && !status.contains(text); look++) {
            Thread.sleep(50);
            status = window.say("status");
        }
        assertTrue(status.contains(text), status);
        return status;
    }

    /** Without text. */
    private static BufferedImage bare(DrivenWindow window) throws IOException {
        window.tap("SPACE");
        return window.shot("bare");
    }

    private static Color wall(BufferedImage image) {
        return new Color(image.getRGB(SIZE / 10, MIDDLE));
    }

    @Test
    void draggedBlock_takesItsShadowAlongAndIsSaved() throws Exception {
        Path file = rendered();
        try (DrivenWindow window = new DrivenWindow(file, folder)) {
            window.tap("M");
            until(window, "click on an object");
            BufferedImage before = bare(window);
            window.say("click " + X + " " + MIDDLE);
            assertTrue(window.say("status").contains("cornell-box:3"), window.say("status"));
            window.say("drag " + X + " " + MIDDLE + " " + (X + 20) + " " + MIDDLE);
            String moved = until(window, "at rest");
            assertFalse(moved.contains("anew"), moved);
            window.say("drag " + (X + 20) + " " + MIDDLE + " " + (X + 50) + " " + MIDDLE + " CONTROL");
            until(window, "turned by 17 degrees");
            until(window, "at rest");
            String twice = window.say("tell CONTROL+S+S");
            assertTrue(twice.contains("still saving"), twice);
            assertTrue(until(window, "saved").contains("box-edit-1.scene, cornell-box-edit-1.lws"));
            window.say("click 1 1");
            BufferedImage turned = bare(window);
            assertTrue(difference(before, turned) > 1, "the block and its shadow are elsewhere");
            window.say("hold CONTROL+Z 40");
            until(window, "at rest");
            window.say("hold CONTROL+Z 40");
            until(window, "0 left");
            until(window, "at rest");
            double back = difference(before, bare(window));
            double there = difference(before, turned);
            assertTrue(back < there / 3, "differs by " + back + ", turned by " + there);
        }
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of("box-edit-1.scene", "cornell-box-edit-1.lws"), files.map(f -> "" + f.getFileName())
                    .filter(name -> name.contains("edit")).sorted().toList(), "saved once, though S is pressed twice");
        }
        Scene saved = Radiosity.read(folder.resolve("cornell-box-edit-1.lws"), line -> { });
        assertTrue(LitScene.read(folder.resolve("box-edit-1.scene")).meshes().size() > 4);
        Scene edited = SceneSource.read(folder.resolve("box-edit-1.scene"), Optional.empty(), line -> { }).scene();
        Scene original = Radiosity.read(Path.of("scenes/cornell-box.lws"), line -> { });
        for (int t = 0; t < original.triangles(); t++) {
            boolean isBlock = original.hierarchy().of(t) == 2;
            Vec3 way = edited.corner(t, 0).minus(original.corner(t, 0));
            assertTrue(isBlock == way.length() > 1, "corner of " + t + " moved by " + way);
            assertEquals(saved.corner(t, 0), edited.corner(t, 0));
        }
    }

    @Test
    void undoDuringADrag_letsGoOfTheObject() throws Exception {
        try (DrivenWindow window = new DrivenWindow(rendered(), folder)) {
            window.tap("M");
            until(window, "click on an object");
            window.say("click " + X + " " + MIDDLE);
            window.say("drag " + X + " " + MIDDLE + " " + (X + 20) + " " + MIDDLE);
            window.say("mouse PRESSED " + (X + 20) + " " + MIDDLE);
            window.say("mouse DRAGGED " + (X + 40) + " " + MIDDLE);
            window.say("hold CONTROL+Z 40");
            window.say("mouse DRAGGED " + (X + 60) + " " + MIDDLE);
            window.say("mouse RELEASED " + (X + 60) + " " + MIDDLE);
            until(window, "undone, 0 left");
            window.say("hold CONTROL+Z 40");
            assertEquals("edit: nothing to undo", window.say("status"), "the second drag is no edit");
        }
    }

    @Test
    void paintedWall_isAnotherColour() throws Exception {
        try (DrivenWindow window = new DrivenWindow(rendered(), folder)) {
            window.tap("M");
            until(window, "click on an object");
            window.say("click " + SIZE / 10 + " " + MIDDLE);
            window.say("paint 30 60 200");
            until(window, "at rest");
            Color wall = wall(window.shot("blue"));
            assertTrue(wall.getBlue() > 2 * wall.getRed(), wall.toString());
            window.tap("ESCAPE");
            assertTrue(window.say("status").contains("not saved"), "once");
            window.say("hold CONTROL+Z 40");
            until(window, "undone");
            until(window, "at rest");
            Color red = wall(window.shot("red"));
            assertTrue(red.getRed() > 2 * red.getBlue(), red.toString());
            window.say("hold CONTROL+S 40");
            assertEquals("edit: nothing to save", window.say("status"));
        }
    }

    /** One line, and the window goes on. */
    @Test
    void sceneFileWithoutItsModel_isNotEdited() throws Exception {
        Path file = rendered();
        Files.delete(folder.resolve("cornell-box.lws"));
        try (DrivenWindow window = new DrivenWindow(file, folder)) {
            window.tap("M");
            until(window, "cornell-box.lws");
            window.say("hold CONTROL+Z 40");
            assertEquals("edit: nothing to undo", window.say("status"));
        }
    }
}
