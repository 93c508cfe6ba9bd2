package radiosity.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.RadiosityRenderer;
import radiosity.cli.render.SceneSource;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.Solve;

/** What is saved of an edited scene, by the format of its model: a lamp of two triangles above a floor of two. */
@Tag("slow")
class EditFilesTest {

    private static final Vec3 BY = new Vec3(.25, .125, 0);

    @TempDir
    Path folder;

    private EditSource rendered(Path model) throws IOException {
        Path file = folder.resolve("lit.scene");
        assertEquals(0, RadiosityRenderer.run("-q", "--accuracy", "50%", model.toString(), file.toString()));
        return SceneSource.read(file, Optional.empty(), line -> { });
    }

    /** Saves the scene with its lamp moved and its floor painted; returns the line for the user. */
    private String save(EditSource source) throws IOException {
        EditHistory history = new EditHistory(source.scene());
        int lamp = history.original().surface(0).emits() ? 0 : 2;
        history.add(new Edit.Moved(history.original().hierarchy().of(lamp), Vec3.ZERO, 0, BY));
        history.add(new Edit.Painted(history.original().surfaceOf()[2 - lamp], new Rgb(.5, .25, .125)));
        Solution solution = Solve.byDefault().accurate(.5).solution(history.scene());
        return new EditFiles(source).save(new LightFollower.Rest(solution, Optional.empty(), 0, 0, 0, 0, ""),
                ToneMapping.automatic(solution));
    }

    private static void assertEdited(Scene original, Scene edited) {
        for (int t = 0; t < original.triangles(); t++) {
            boolean isLamp = original.surface(t).emits();
            assertEquals(isLamp ? BY : Vec3.ZERO, edited.corner(t, 0).minus(original.corner(t, 0)));
            assertEquals(isLamp ? original.surface(t).reflectance() : new Rgb(.5, .25, .125),
                    edited.surface(t).reflectance());
        }
    }

    private Path gltf() throws IOException {
        String positions = "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAIA/AACAPwAAAAAAAIA/AACAPwAAAAAAAAAA";
        return Files.writeString(folder.resolve("room.gltf"), ("{'asset': {'version': '2.0'}, 'scene': 0,"
                + " 'scenes': [{'nodes': [0, 1]}], 'nodes': [{'name': 'floor', 'mesh': 0},"
                + " {'name': 'lamp', 'mesh': 1, 'translation': [0, 1, 1], 'rotation': [1, 0, 0, 0]}],"
                + " 'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'mode': 6, 'material': 0}]},"
                + " {'primitives': [{'attributes': {'POSITION': 0}, 'mode': 6, 'material': 1}]}],"
                + " 'materials': [{'name': 'wood'}, {'name': 'glow', 'emissiveFactor': [1, 1, 1]}],"
                + " 'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 4, 'type': 'VEC3'}],"
                + " 'bufferViews': [{'buffer': 0, 'byteLength': 48}], 'buffers': [{'byteLength': 48,"
                + " 'uri': 'data:application/octet-stream;base64," + positions + "'}]}").replace('\'', '"'));
    }

    @Test
    void gltfModel_isSavedWithTheSceneFileThatNamesIt() throws IOException {
        EditSource source = rendered(gltf());
        assertEquals("saved lit-edit-1.scene, room-edit-1.gltf", save(source));
        EditSource saved = SceneSource.read(folder.resolve("lit-edit-1.scene"), Optional.empty(), line -> { });
        assertEquals(folder.resolve("room-edit-1.gltf"), saved.model());
        assertEdited(source.scene(), saved.scene());
    }

    /** It would be the model of no scene file. */
    @Test
    void sceneFileThatCannotBeWritten_leavesNoCopyOfTheModel() throws IOException {
        EditSource source = rendered(gltf());
        EditSource elsewhere = new EditSource(source.model(), source.reading(), source.scene(),
                folder.resolve("gone/lit.scene"), source.light(), source.settings(), source.kept(),
                source.commandLine());
        assertThrows(IOException.class, () -> save(elsewhere));
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of("lit.scene", "room.gltf"), files.map(f -> "" + f.getFileName()).sorted().toList());
        }
    }

    @Test
    void objModel_isNotSavedAndTheLineSaysSo() throws IOException {
        Files.writeString(folder.resolve("room.mtl"), "newmtl wood\nKd .8 .8 .8\nnewmtl glow\nKe 1 1 1\n");
        EditSource source = rendered(Files.writeString(folder.resolve("room.obj"), "mtllib room.mtl\no floor\n"
                + "usemtl wood\nv 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nf 1 2 3 4\no lamp\n"
                + "usemtl glow\nv 0 1 0\nv 0 1 1\nv 1 1 1\nv 1 1 0\nf 8 7 6 5\n"));
        String why = "expected a LightWave scene or a glTF file to save a copy of, got an OBJ file";
        assertTrue(new EditFiles(source).obstacle().orElseThrow().contains(why));
        String line = save(source);
        assertTrue(line.startsWith("saved lit-edit-1.scene; ") && line.contains(why), line);
    }
}
