package radiosity.input.gltf;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;
import radiosity.testkit.Mutation;

/** Mutants of sound files end in a scene or in the one exception; nothing else is thrown and nothing hangs. */
@Tag("slow")
@Timeout(value = 240, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class GltfFuzzTest {

    private static final int MUTANTS = 4000;
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?");
    private static final String[] BAD = {"-1", "0", "1", "2", "7", "255", "65536", "2147483647", "4294967295",
        "99999999999999999999", "1e308", "1e999", "0.5", "null", "[]", "{}", "\"x\"", "true"};

    @TempDir
    Path folder;

    /** Numbers and references changed one by one, which reach further than changed bytes. */
    @Test
    void changedNumbers_endInASceneOrTheOneException() throws IOException {
        String sound = sound();
        Random random = new Random(3);
        int after = sound.indexOf("bufferViews");
        List<MatchResult> numbers = NUMBER.matcher(sound).results().filter(m -> m.start() > after).toList();
        for (int i = 0; i < MUTANTS; i++) {
            MatchResult at = numbers.get(random.nextInt(numbers.size()));
            String changed = sound.substring(0, at.start()) + BAD[random.nextInt(BAD.length)]
                    + sound.substring(at.end());
            read(changed.getBytes(StandardCharsets.UTF_8));
        }
    }

    @Test
    void changedBytes_endInASceneOrTheOneException() throws IOException {
        byte[] sound = sound().getBytes(StandardCharsets.UTF_8);
        Random random = new Random(4);
        for (int i = 0; i < MUTANTS; i++) {
            read(Mutation.of(sound, random));
        }
    }

    /** A binary that Blender wrote: its header, its chunks and the JSON in it. */
    @Test
    void changedBinaries_endInASceneOrTheOneException() throws IOException, URISyntaxException {
        byte[] sound = Files.readAllBytes(Path.of(GltfFuzzTest.class.getResource("/radiosity/input/room.glb").toURI()));
        Random random = new Random(6);
        for (int i = 0; i < MUTANTS; i++) {
            read(Mutation.of(sound, random));
        }
        for (int length = 0; length < sound.length; length += 1 + length / 64) {
            read(Arrays.copyOf(sound, length));
        }
    }

    @Test
    void jsonWithoutEnd_isOneLine() throws IOException {
        read("[".repeat(1_000_000).getBytes(StandardCharsets.UTF_8));
        read(("{\"asset\":" + "{\"a\":".repeat(100_000)).getBytes(StandardCharsets.UTF_8));
        read(("{\"asset\":{\"version\":\"2.0\"},\"scenes\":[" + "{},".repeat(1_000_000) + "{}]}")
                .getBytes(StandardCharsets.UTF_8));
    }

    private void read(byte[] bytes) throws IOException {
        Path place = folder.resolve("a.gltf");
        Files.write(place, new byte[0]);
        ReadOptions options = ReadOptions.defaults().withMaxTriangles(1_000_000);
        List<String> told = new ArrayList<>();
        Diagnostics notes = new Diagnostics("a.gltf", told::add, false);
        try {
            GltfReader.read(bytes, "a.gltf", new FileSearch(place, List.of(), options.map(), start -> false, notes),
                    options, notes);
        } catch (SceneFormatException e) {
            told.add(e.getMessage());
        }
        for (String line : told) {
            assertTrue(line.chars().noneMatch(Character::isISOControl), line);
        }
    }

    /** Most of what a file can have. */
    private static String sound() {
        Model model = new Model();
        int position = model.floats("VEC3", Model.SQUARE);
        int sparse = model.accessor("VEC3", 5126, 4, ",\"bufferView\":0,\"sparse\":{\"count\":1,\"indices\":{"
                + "\"componentType\":5123,\"bufferView\":" + model.view(Model.shorts(1), 0)
                + "},\"values\":{\"bufferView\":" + model.view(4, 0, 0) + "}}");
        int quantised = model.accessor("VEC3", 5122, 3, ",\"normalized\":true,\"bufferView\":" + model.view(
                Model.shorts(0, 0, 0, 7, 32767, 0, 0, 7, 0, 32767, 0, 7), 8));
        int uv = model.floats("VEC2", 0, 0, 1, 0, 1, 1, 0, 1);
        int colours = model.floats("VEC4", 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 1, 0, 0, 1, 1);
        int joints = model.accessor("VEC4", 5121, 4, ",\"bufferView\":" + model.view(new byte[16], 0));
        int weights = model.floats("VEC4", 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0);
        int bound = model.floats("MAT4", 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
        int indices = model.indices(0, 1, 2, 0, 2, 3);
        int moves = model.floats("VEC3", 1, 0, 0, 0, 1, 0);
        return model.text("'extensionsRequired':['KHR_mesh_quantization'],'scene':0,'scenes':[{'nodes':[0]}]",
                "'nodes':[{'name':'a','mesh':0,'children':[1,2,3]},{'mesh':1,'scale':[2,2,2],'rotation':[0,1,0,1]},"
                        + "{'mesh':0,'skin':0,'camera':0},{'mesh':1,'weights':[1],'extensions':{'KHR_lights_punctual':"
                        + "{'light':0},'EXT_mesh_gpu_instancing':{'attributes':{'TRANSLATION':" + moves + "}}}}]",
                "'meshes':[{'primitives':[{'attributes':{'POSITION':" + position + ",'TEXCOORD_0':" + uv
                        + ",'COLOR_0':" + colours + ",'JOINTS_0':" + joints + ",'WEIGHTS_0':" + weights
                        + "},'indices':" + indices + ",'material':0},{'attributes':{'POSITION':" + quantised
                        + "},'mode':5}]},{'weights':[0.5],'primitives':[{'attributes':{'POSITION':" + sparse
                        + "},'mode':6,'targets':[{'POSITION':" + position + "}]}]}]",
                "'materials':[{'emissiveFactor':[1,1,1],'pbrMetallicRoughness':{'baseColorTexture':{'index':0,"
                        + "'extensions':{'KHR_texture_transform':{'scale':[2,2],'rotation':1}}}}}]",
                "'textures':[{'source':0,'sampler':0}],'samplers':[{'wrapS':33071}],'images':[{'bufferView':1}]",
                "'skins':[{'joints':[1],'inverseBindMatrices':" + bound + "}]",
                "'cameras':[{'type':'perspective','perspective':{'yfov':1}}]",
                "'extensions':{'KHR_lights_punctual':{'lights':[{'type':'spot','spot':{'outerConeAngle':0.5}}]}}");
    }
}
