package radiosity.edit.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.Radiosity;
import radiosity.edit.Edit;
import radiosity.edit.EditHistory;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** Edits of a glTF scene come back from the copy in which they were saved. */
class GltfCopyTest {

    /** Squares at nodes of all kinds. */
    private static final String ROOM = """
        {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0, 1, 4, 6, 7]}],
        'extensionsUsed': ['EXT_mesh_gpu_instancing', 'KHR_lights_punctual', 'KHR_materials_pbrSpecularGlossiness'],
        'nodes': [
          {'name': 'floor', 'mesh': 0, 'scale': [9, 9, 9], 'extras': {'kept': [1, 2.5]}},
          {'name': 'table', 'children': [2, 3], 'translation': [1, 0, 2], 'rotation': [0, 0.6, 0, 0.8],
           'scale': [2, 2, 2]},
          {'name': 'cup', 'mesh': 1, 'translation': [0.25, 1, 0.1], 'rotation': [0.5, 0.5, 0.5, 0.5],
           'scale': [1, 0.5, 2]},
          {'name': 'plate', 'mesh': 1, 'matrix': [1, 0, 0, 0, 0, 1, 0.5, 0, 0, 0, 1, 0, 0.5, 0.75, 0.25, 1]},
          {'name': 'squeezed', 'children': [5], 'scale': [1, 1, 3]},
          {'name': 'stool', 'mesh': 2, 'translation': [3, 0.5, 1]},
          {'name': 'row', 'mesh': 2, 'translation': [5, 0.5, 1], 'extensions': {'EXT_mesh_gpu_instancing': {
           'attributes': {'TRANSLATION': 1}}}},
          {'name': 'lamp', 'mesh': 3, 'translation': [4, 2, 4], 'children': [8]},
          {'name': 'bulb', 'extensions': {'KHR_lights_punctual': {'light': 0}}}],
        'meshes': [
          {'name': 'a', 'primitives': [{'attributes': {'POSITION': 0}, 'indices': 2, 'material': 1}]},
          {'name': 'b', 'primitives': [{'attributes': {'POSITION': 0}, 'indices': 2, 'material': 0}]},
          {'name': 'c', 'primitives': [{'attributes': {'POSITION': 0}, 'indices': 2}]},
          {'name': 'd', 'primitives': [{'attributes': {'POSITION': 0}, 'indices': 2, 'material': 2}]}],
        'materials': [
          {'name': 'wood', 'pbrMetallicRoughness': {'baseColorFactor': [0.5, 0.25, 0.125, 0.75], 'metallicFactor': 0}},
          {'name': 'carpet', 'extensions': {'KHR_materials_pbrSpecularGlossiness': {'diffuseFactor': [0.5, 0.5, 0.5, 1],
           'glossinessFactor': 0.25}}},
          {'name': 'glow', 'emissiveFactor': [1, 1, 0.5]}],
        'extensions': {'KHR_lights_punctual': {'lights': [{'name': 'bulb', 'type': 'point', 'intensity': 3}]}},
        'accessors': [
          {'bufferView': 0, 'componentType': 5126, 'count': 4, 'type': 'VEC3'},
          {'bufferView': 1, 'componentType': 5126, 'count': 2, 'type': 'VEC3'},
          {'bufferView': 2, 'componentType': 5123, 'count': 6, 'type': 'SCALAR'}],
        'bufferViews': [{'buffer': 0, 'byteOffset': 0, 'byteLength': 48}, {'buffer': 0, 'byteOffset': 48,
          'byteLength': 24}, {'buffer': 0, 'byteOffset': 72, 'byteLength': 12}],
        'buffers': [{'byteLength': 84, 'uri': 'room.bin'}]}
        """.replace('\'', '"');
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    Path folder;
    private Path source;
    private EditHistory history;

    @BeforeEach
    void write() throws IOException {
        Files.write(folder.resolve("room.bin"), arrays());
        begin(Files.writeString(folder.resolve("room.gltf"), ROOM));
    }

    private void begin(Path file) throws IOException {
        source = file;
        history = new EditHistory(read(file));
    }

    private static byte[] arrays() {
        ByteBuffer bytes = ByteBuffer.allocate(84).order(ByteOrder.LITTLE_ENDIAN);
        for (float x : new float[] {0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0.5f, 0, 2}) {
            bytes.putFloat(x);
        }
        for (int i : new int[] {0, 1, 2, 0, 2, 3}) {
            bytes.putShort((short) i);
        }
        return bytes.array();
    }

    private static Scene read(Path file) throws IOException {
        return Radiosity.read(file, line -> { });
    }

    private int node(String name) {
        return history.original().hierarchy().nodes().stream().map(n -> n.name()).toList().indexOf(name);
    }

    private void move(String name, double turn) {
        history.add(new Edit.Moved(node(name), new Vec3(1, 0.5, -2), turn, new Vec3(-.3, 0.1, .7)));
    }

    private void paint(String name) {
        int surface = history.original().surfaces().stream().map(s -> s.name()).toList().indexOf(name);
        history.add(new Edit.Painted(surface, new Rgb(.7, .3, .1)));
    }

    private Path copy() {
        String name = source.getFileName().toString();
        return folder.resolve("copy" + name.substring(name.indexOf('.')));
    }

    private Scene saved() throws IOException {
        assertEquals(List.of(copy()), ModelCopy.write(source, ReadOptions.defaults(), history.original(),
                history.scene(), copy()));
        return read(copy());
    }

    private void assertComesBack() throws IOException {
        Scene got = saved();
        Scene expected = history.scene();
        assertEquals(expected.triangles(), got.triangles());
        for (int i = 0; i < 3 * got.triangles(); i++) {
            Vec3 p = got.corner(i / 3, i % 3);
            assertTrue(p.minus(expected.corner(i / 3, i % 3)).length() < 1e-12, "corner " + i + " at " + p);
        }
        assertEquals(expected.surfaces(), got.surfaces());
        assertEquals(expected.lights(), got.lights());
    }

    private JsonNode json() throws IOException {
        return JSON.readTree(copy().toFile());
    }

    private void assertRefused(String why) {
        SceneFormatException refused = assertThrows(SceneFormatException.class, this::saved);
        assertTrue(refused.getMessage().contains(why), refused.getMessage());
        assertFalse(Files.exists(copy()));
    }

    /*---- Nodes ----*/

    @Test
    void movedAndTurnedNodes_comeBack() throws IOException {
        move("table", 0.4);
        move("cup", -1);
        move("plate", 2);
        move("stool", 0);
        move("row", 3);
        assertComesBack();
    }

    /** Its parent is three times as long in one direction, and no rotation and scale say that it is turned there. */
    @Test
    void nodeTurnedInAScaledParent_hasAMatrix() throws IOException {
        move("stool", 1);
        assertComesBack();
        assertTrue(json().at("/nodes/5").has("matrix") && !json().at("/nodes/5").has("translation"));
    }

    @Test
    void moveAlone_changesATranslation() throws IOException {
        move("cup", 0);
        assertComesBack();
        ObjectNode was = (ObjectNode) JSON.readTree(ROOM);
        ObjectNode is = (ObjectNode) json();
        ((ObjectNode) was.at("/nodes/2")).remove("translation");
        ((ObjectNode) is.at("/nodes/2")).remove("translation");
        assertEquals(was, is);
    }

    @Test
    void instance_isRefused() {
        history.add(new Edit.Moved(node("row") + 1, Vec3.ZERO, 0, new Vec3(0, 1, 0)));
        assertRefused("instances");
    }

    @Test
    void animatedNode_isRefused() throws IOException {
        String animations = "'animations': [{'channels': [{'sampler': 0, 'target': {'node': 5, 'path': 'rotation'}}],"
                + " 'samplers': [{'input': 0, 'output': 0}]}], ";
        begin(Files.writeString(folder.resolve("moving.gltf"),
                ROOM.replace("\"meshes\"", animations.replace('\'', '"') + "\"meshes\"")));
        move("cup", 0);
        assertComesBack();
        Files.delete(copy());
        move("stool", 0);
        assertRefused("animation");
    }

    @Test
    void lampWithItsLight_isRefused() {
        move("lamp", 0);
        assertRefused("light without geometry");
    }

    /*---- Materials ----*/

    @Test
    void paintedMaterials_comeBack() throws IOException {
        paint("wood");
        paint("carpet");
        paint("default");
        paint("glow");
        assertComesBack();
        assertEquals("[0.699999988079071,0.30000001192092896,0.10000000149011612,0.75]",
                json().at("/materials/0/pbrMetallicRoughness/baseColorFactor").toString());
    }

    /*---- Files ----*/

    @Test
    void binary_keepsItsArrays() throws IOException {
        byte[] text = ROOM.replace(", \"uri\": \"room.bin\"", "").getBytes(StandardCharsets.UTF_8);
        int padded = text.length + 3 & ~3;
        ByteBuffer file = ByteBuffer.allocate(12 + 8 + padded + 8 + 84).order(ByteOrder.LITTLE_ENDIAN);
        file.putInt(0x46546C67).putInt(2).putInt(file.capacity()).putInt(padded).putInt(0x4E4F534A).put(text);
        while (file.position() < 20 + padded) {
            file.put((byte) ' ');
        }
        file.putInt(84).putInt(0x004E4942).put(arrays());
        begin(Files.write(folder.resolve("room.glb"), file.array()));
        move("table", 0.4);
        paint("wood");
        assertComesBack();
        byte[] copy = Files.readAllBytes(copy());
        assertEquals(0, copy.length % 4);
        assertEquals(copy.length, ByteBuffer.wrap(copy).order(ByteOrder.LITTLE_ENDIAN).getInt(8));
        assertArrayEquals(arrays(), Arrays.copyOfRange(copy, copy.length - 84, copy.length));
    }

    @Test
    void objFile_isRefused() throws IOException {
        begin(Files.writeString(folder.resolve("room.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        assertRefused("OBJ");
    }
}
