package radiosity.input.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Camera;
import radiosity.scene.ImageMap;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.scene.Specular;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** What the reader makes of small files whose content is known number by number. */
class GltfReaderTest {

    private static final String PAINT = "{'name':'paint','pbrMetallicRoughness':{'baseColorFactor':[0.1,0.2,0.3,1]}}";

    @TempDir
    Path folder;
    private final Model model = new Model();
    private final List<String> told = new ArrayList<>();

    private Scene read(String text) throws IOException {
        return read(Files.writeString(folder.resolve("a.gltf"), text));
    }

    /** A bent strip of three squares, by 30 degrees and then by 90; normals are one number per square end. */
    private String strip(String more, int... normals) {
        double[] turns = {0, Math.toRadians(30), Math.toRadians(120)};
        float[] points = new float[54];
        float[] n = new float[54];
        double x = 0;
        double y = 0;
        for (int f = 0; f < 3; f++) {
            double toX = x + Math.cos(turns[f]);
            double toY = y + Math.sin(turns[f]);
            double[][] corners = {{x, y, 0, 0}, {x, y, 1, 0}, {toX, toY, 1, 1}, {x, y, 0, 0}, {toX, toY, 1, 1},
                {toX, toY, 0, 1}};
            for (int k = 0; k < 6; k++) {
                int i = 3 * (6 * f + k);
                for (int a = 0; a < 3; a++) {
                    points[i + a] = (float) corners[k][a];
                }
                double turn = normals.length == 0 ? 0 : Math.toRadians(normals[2 * f + (int) corners[k][3]]);
                n[i] = (float) -Math.sin(turn);
                n[i + 1] = (float) Math.cos(turn);
            }
            x = toX;
            y = toY;
        }
        return model.one("'POSITION':" + model.floats("VEC3", points)
                + (normals.length == 0 ? "" : ",'NORMAL':" + model.floats("VEC3", n)), ",'material':0", more,
                "{'name':'s'}");
    }

    @Test
    void normals_giveTheSmoothingAngle() throws IOException {
        assertEquals(0, read(strip("")).surface(0).smoothing(), "no normals are flat ones");
        assertEquals(0, read(strip("", 0, 0, 30, 30, 120, 120)).surface(0).smoothing(), 1e-12, "those of the facets");
        assertEquals(Math.toRadians(30), read(strip("", 0, 15, 15, 30, 120, 120)).surface(0).smoothing(), .02);
        assertEquals(Math.toRadians(90), read(strip("", 0, 15, 15, 75, 75, 120)).surface(0).smoothing(), .02);
        double angle = read(strip("", 0, 0, 30, 75, 75, 120)).surface(0).smoothing();
        assertEquals(0, angle, "no angle joins the second edge alone, and as much is wrong without any");
    }

    private Scene read(Path file) throws IOException {
        return GltfReader.read(file, ReadOptions.defaults(), told::add);
    }

    private String refused(String text) {
        return assertThrows(SceneFormatException.class, () -> read(text)).getMessage();
    }

    private String square(String more, String node, String materials) {
        return model.one("'POSITION':" + model.floats("VEC3", Model.SQUARE),
                ",'indices':" + model.indices(0, 1, 2, 0, 2, 3) + ",'material':0" + more, node, materials);
    }

    @Test
    void mesh_standsWhereItsNodeIs_withItsMaterial() throws IOException {
        Scene scene = read(square("", ",'translation':[1,2,3],'scale':[2,3,1],'rotation':[0,0.7071067811865476,0,"
                + "0.7071067811865476]", "{'name':'paint','doubleSided':true,'emissiveFactor':[1,0.5,0],"
                + "'pbrMetallicRoughness':{'baseColorFactor':[0.1,0.2,0.3,1]},"
                + "'extensions':{'KHR_materials_emissive_strength':{'emissiveStrength':8}}}"));
        assertEquals(List.of(), told);
        assertEquals(2, scene.triangles());
        assertEquals(6, scene.area(), 1e-12);
        Vec3 far = scene.corner(0, 2);
        assertEquals(1, far.x(), 1e-12);
        assertEquals(5, far.y(), 1e-12);
        assertEquals(1, far.z(), 1e-12, "x goes to -z");
        Surface paint = scene.surface(0);
        assertEquals(new Rgb(.1, .2, .3), paint.reflectance());
        assertEquals(new Rgb(8, 4, 0), paint.exitance());
        assertTrue(paint.twoSided());
        assertEquals("n", scene.hierarchy().nodes().get(0).name());
        assertEquals("m", scene.hierarchy().nodes().get(0).geometry());
    }

    /** Strips and fans of the same square; each triangle looks towards +z. */
    @ParameterizedTest
    @CsvSource({"4, 0 1 2 0 2 3", "5, 0 1 3 2", "6, 0 1 2 3"})
    void modes_giveTheSameSquare(int mode, String indices) throws IOException {
        int[] numbers = Arrays.stream(indices.split(" ")).mapToInt(Integer::parseInt).toArray();
        Scene scene = read(model.one("'POSITION':" + model.floats("VEC3", Model.SQUARE),
                ",'indices':" + model.indices(numbers) + ",'mode':" + mode, "", PAINT));
        assertEquals(2, scene.triangles());
        for (int t = 0; t < 2; t++) {
            assertEquals(0, scene.cross(t).minus(new Vec3(0, 0, 1)).length());
        }
    }

    @Test
    void nullInJson_isLikeNoValue() throws IOException {
        Scene scene = read(square(",'mode':null,'targets':null", ",'matrix':null,'scale':[2,3,1],'camera':null",
                "{'name':null,'emissiveFactor':null,'pbrMetallicRoughness':null}"));
        assertEquals(6, scene.area(), 1e-12);
        assertEquals(Rgb.BLACK, scene.surface(0).exitance());
    }

    @Test
    void mirroredNode_isSeenFromTheSameSide() throws IOException {
        Scene scene = read(square("", ",'scale':[-1,1,1]", PAINT));
        assertEquals(new Vec3(0, 0, 1), scene.cross(0));
    }

    @Test
    void meshWithoutIndices_andMatrix() throws IOException {
        Scene scene = read(model.one("'POSITION':" + model.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0), "",
                ",'matrix':[1,0,0,0, 0,2,0,0, 0,0,1,0, 5,6,7,1]", PAINT));
        assertEquals(new Vec3(5, 8, 7), scene.corner(0, 2));
    }

    /** Positions of 16 bit with a stride, scaled by the node as KHR_mesh_quantization has it. */
    @Test
    void quantisedPositions_areScaledBack() throws IOException {
        int position = model.accessor("VEC3", 5122, 3, ",\"normalized\":true,\"bufferView\":" + model.view(
                Model.shorts(0, 0, 0, 7, 32767, 0, 0, 7, 0, 32767, 0, 7), 8));
        Scene scene = read(model.one("'POSITION':" + position, "", ",'scale':[3,3,3]", PAINT)
                .replace("\"scene\":0", "\"extensionsRequired\":[\"KHR_mesh_quantization\"],\"scene\":0"));
        assertEquals(4.5, scene.area(), 1e-12);
        assertEquals(new Vec3(3, 0, 0), scene.corner(0, 1));
    }

    @Test
    void sparseAccessors_replaceElements_withAndWithoutOthersBelow() throws IOException {
        String sparse = ",\"sparse\":{\"count\":2,\"indices\":{\"componentType\":5123,\"bufferView\":"
                + model.view(Model.shorts(1, 2), 0) + "},\"values\":{\"bufferView\":" + model.view(4, 0, 0, 0, 2, 0)
                + "}}";
        int position = model.accessor("VEC3", 5126, 3, sparse);
        assertEquals(4, read(model.one("'POSITION':" + position, "", "", PAINT)).area(), 1e-12);
        int over = model.accessor("VEC3", 5126, 3, ",\"bufferView\":" + model.view(1, 0, 0, 9, 9, 9, 9, 9, 9) + sparse);
        assertEquals(3, read(model.one("'POSITION':" + over, "", "", PAINT)).area(), 1e-12);
    }

    /** The square is one triangle of its first corner alone until the sparse indices replace it. */
    @Test
    void sparseIndices_replaceIndices_withAndWithoutOthersBelow() throws IOException {
        String sparse = ",\"sparse\":{\"count\":4,\"indices\":{\"componentType\":5123,\"bufferView\":"
                + model.view(Model.shorts(1, 2, 4, 5), 0) + "},\"values\":{\"bufferView\":"
                + model.view(Model.shorts(1, 2, 2, 3), 0) + "}}";
        String position = "'POSITION':" + model.floats("VEC3", Model.SQUARE);
        for (String below : List.of("", ",\"bufferView\":" + model.view(Model.shorts(0, 0, 0, 0, 0, 0), 0))) {
            int indices = model.accessor("SCALAR", 5123, 6, below + sparse);
            Scene scene = read(model.one(position, ",'indices':" + indices, "", PAINT));
            assertEquals(2, scene.triangles());
            assertEquals(1, scene.area(), 1e-12);
        }
        int outside = model.accessor("SCALAR", 5123, 5, sparse);
        String text = model.one(position, ",'indices':" + outside, "", PAINT);
        assertThrows(SceneFormatException.class, () -> read(text));
    }

    /** Black at one corner of a triangle, white at the others, times the base colour. */
    @Test
    void vertexColours_areFactorsOfReflectance_linearBetweenCorners() throws IOException {
        int colours = model.accessor("VEC4", 5121, 4, ",\"normalized\":true,\"bufferView\":" + model.view(new byte[] {
            0, 0, 0, 0, -1, -1, -1, 0, -1, -1, -1, 0, 51, 102, -1, 9}, 0));
        Scene scene = read(model.one("'POSITION':" + model.floats("VEC3", Model.SQUARE) + ",'COLOR_0':" + colours,
                ",'indices':" + model.indices(0, 1, 2, 0, 2, 3) + ",'material':0", "",
                "{'pbrMetallicRoughness':{'baseColorFactor':[0.5,0.5,0.25,1]}}"));
        assertEquals(0, scene.material(0, new Vec3(0, 0, 0)).reflectance().max(), 1e-9);
        assertEquals(.5, scene.material(0, new Vec3(1, 0, 0)).reflectance().r(), 1e-9);
        assertEquals(.25, scene.material(0, new Vec3(.5, .25, 0)).reflectance().g(), 1e-9);
        Rgb mean = scene.meanMaterial(1, scene.corner(1, 0), scene.corner(1, 1), scene.corner(1, 2)).reflectance();
        assertEquals(.5 * (0 + 1 + .2) / 3, mean.r(), 1e-7);
        assertEquals(.25 * (0 + 1 + 1) / 3, mean.b(), 1e-7);
    }

    @Test
    void textures_areImages_thatLieAsTheFileSays() throws IOException {
        String text = model.one("'POSITION':" + model.floats("VEC3", Model.SQUARE) + ",'TEXCOORD_1':"
                + model.floats("VEC2", 0, 0, 1, 0, 1, 1, 0, 1), ",'indices':" + model.indices(0, 1, 2, 0, 2, 3)
                + ",'material':0", "", "{'name':'wood','emissiveFactor':[2,2,2],'emissiveTexture':{'index':1,"
                + "'texCoord':1,'extensions':{'KHR_texture_transform':{'offset':[0.5,0.25],'scale':[2,3]}}},"
                + "'pbrMetallicRoughness':{'baseColorFactor':[0.5,0.5,0.5,1],'baseColorTexture':{'index':0,'extensions':{"
                + "'KHR_texture_transform':{'offset':[0.5,0.25],'scale':[2,3],'texCoord':1}}}}}");
        text = text.substring(0, text.length() - 1) + """
                ,"textures":[{"source":0,"sampler":0},{"source":1}],"samplers":[{"wrapS":33071,"wrapT":33648}],
                "images":[{"uri":"my%20Wood.PNG"},{"uri":"data:image/png;base64,AAEC"}]}""";
        Files.write(folder.resolve("My wood.png"), new byte[0]);
        Scene scene = read(text);
        assertEquals(List.of(), told);
        List<ImageMap> maps = scene.surfaces().get(0).textures();
        assertTrue(maps.get(0).image().name().endsWith("My wood.png"));
        assertTrue(maps.get(0).coded());
        assertEquals(List.of(ImageMap.Wrap.EDGE, ImageMap.Wrap.MIRROR), List.of(maps.get(0).wrapU(),
                maps.get(0).wrapV()));
        assertEquals(new Rgb(.5, .5, .5), maps.get(0).scale());
        assertEquals(ByteBuffer.wrap(new byte[] {0, 1, 2}), maps.get(1).image().content().orElseThrow());
        assertEquals(new Rgb(2, 2, 2), maps.get(1).scale());
        float[] uv = scene.textureCoordinates();
        assertEquals(.5f, uv[0]);
        assertEquals(.75f, uv[1], "v upwards: 1 - 0.25");
        assertEquals(2.5f, uv[2]);
        assertEquals(-2.25f, uv[5], "1 - (3 * 1 + 0.25)");
    }

    @Test
    void triangleWithACoordinateThatIsNoFiniteNumber_hasNoImage() throws IOException {
        String text = model.one("'POSITION':" + model.floats("VEC3", Model.SQUARE) + ",'TEXCOORD_0':"
                + model.floats("VEC2", 0, 0, 1, 0, 1, 1, 0, Float.POSITIVE_INFINITY), ",'indices':"
                + model.indices(0, 1, 2, 0, 2, 3) + ",'material':0", "",
                "{'name':'wood','pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}");
        float[] uv = read(text.substring(0, text.length() - 1) + ",\"textures\":[{\"source\":0}],\"images\":"
                + "[{\"uri\":\"data:image/png;base64,AAEC\"}]}").textureCoordinates();
        assertTrue(Float.isFinite(uv[5]));
        for (int i = 6; i < 12; i++) {
            assertTrue(Float.isNaN(uv[i]));
        }
    }

    /** Base colour 1 is the default: the image decides, and where it does not lie, the surface is darkened. */
    @Test
    void whiteUnderAnImage_isNotDarkened() throws IOException {
        String text = model.one("'POSITION':" + model.floats("VEC3", Model.SQUARE) + ",'TEXCOORD_0':"
                + model.floats("VEC2", 0, 0, 1, 0, 1, 1, 0, 1), ",'mode':6,'material':0", "",
                "{'name':'wood','pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}");
        text = text.substring(0, text.length() - 1)
                + ",\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"data:image/png;base64,AAEC\"}]}";
        assertEquals(Rgb.grey(1), read(text).surfaces().get(0).textures().get(0).scale());
        assertEquals(List.of(), told);
        read(text.replace("TEXCOORD_0", "TEXCOORD_7"));
        assertEquals(List.of("a.gltf: reflectances of 1 and more are taken as 0.9999: wood"), told);
    }

    @Test
    void whiteUnderAnImageThatIsMissing_isALightGrey() throws IOException {
        String text = model.one("'POSITION':" + model.floats("VEC3", Model.SQUARE) + ",'TEXCOORD_0':"
                + model.floats("VEC2", 0, 0, 1, 0, 1, 1, 0, 1), ",'mode':6,'material':0", "",
                "{'name':'wood','pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}");
        text = text.substring(0, text.length() - 1);
        assertEquals(Rgb.grey(.8), read(text + ",\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"a.png\"}]}")
                .surfaces().get(0).reflectance());
        assertEquals(Rgb.grey(.8), read(text + ",\"textures\":[{}]}").surfaces().get(0).reflectance());
        assertEquals(List.of("a.gltf: images that are not found leave the base colour, a light grey where it is white:"
                + " a.png", "a.gltf: textures without an image leave the base colour, a light grey where it is white:"
                + " /textures/0"), told);
    }

    /** A quarter turn counter-clockwise as one sees the image: u to the right becomes v upwards. */
    @Test
    void rotation_turnsCoordinatesCounterClockwise() {
        TextureLie lie = TextureLie.of(0, new double[] {1, 1}, Math.PI / 2, new double[2]);
        assertEquals(0, lie.u(1, 0), 1e-6);
        assertEquals(2, lie.v(1, 0), 1e-6, "1 - (-1)");
    }

    /** A library of parts: the format allows a file without scenes. */
    @Test
    void fileWithoutScenes_hasTheNodesThatAreNoChildren() throws IOException {
        int position = model.floats("VEC3", Model.SQUARE);
        String text = model.text("'nodes':[{'name':'part','mesh':0},{'name':'whole','children':[0]},"
                + "{'name':'alone','mesh':0}]",
                "'meshes':[{'primitives':[{'attributes':{'POSITION':" + position + "},'mode':6}]}]");
        assertEquals(List.of("whole|-1", "part|0", "alone|-1"), read(text).hierarchy().nodes().stream()
                .map((SceneNode n) -> n.name() + "|" + n.parent()).toList());
    }

    @Test
    void hierarchy_namesAndInstances_areTheFiles() throws IOException {
        int move = model.floats("VEC3", 0, 0, 1, 0, 0, 2);
        int position = model.floats("VEC3", Model.SQUARE);
        String text = model.text("'scene':1,'scenes':[{'nodes':[3]},{'nodes':[0]}]",
                "'nodes':[{'name':'room','children':[2,1]},{'name':'chair','mesh':0,'translation':[5,0,0]},"
                        + "{'name':'table','mesh':1,'children':[4],'scale':[2,2,2]},{'name':'elsewhere','mesh':0},"
                        + "{'name':'cups','mesh':0,'extensions':{'EXT_mesh_gpu_instancing':{'attributes':{"
                        + "'TRANSLATION':" + move + "}}}}]",
                "'meshes':[{'name':'quad','primitives':[{'attributes':{'POSITION':" + position + "},'mode':6}]},"
                        + "{'name':'quad','primitives':[{'attributes':{'POSITION':" + position + "},'mode':6}]}]");
        Scene scene = read(text);
        assertEquals(List.of("room|-1|", "table|0|quad", "cups|1|", "cups|2|quad#0", "cups|2|quad#0",
                "chair|0|quad#0"), scene.hierarchy().nodes().stream()
                .map((SceneNode n) -> n.name() + "|" + n.parent() + "|" + n.geometry()).toList());
        assertEquals(4 + 4 + 4 + 1, scene.area(), 1e-12);
        assertEquals(2, scene.corner(2, 0).z(), "the first instance, moved by 1 in a node that is twice as large");
        assertEquals(4, scene.corner(4, 0).z());
        assertEquals(4 + 4 + 1, read(text.replace("\"TRANSLATION\"", "\"_ID\"")).area(), 1e-12,
                "instances without places of their own are drawn once");
    }

    @Test
    void lights_haveCandelaAndLux_asTheyAreWritten() throws IOException {
        String text = square("", ",'translation':[0,5,0],'rotation':[-0.7071067811865476,0,0,0.7071067811865476],"
                + "'children':[1,2],'extensions':{'KHR_lights_punctual':{'light':0}}},{'translation':[1,0,0],"
                + "'extensions':{'KHR_lights_punctual':{'light':1}}},{'extensions':{'KHR_lights_punctual':{'light':2}}",
                PAINT);
        text = text.substring(0, text.length() - 1) + """
                ,"extensions":{"KHR_lights_punctual":{"lights":[
                {"type":"directional","intensity":100,"color":[1,0.5,0]},
                {"type":"point","name":"bulb","intensity":40},{"type":"spot","intensity":10,
                "spot":{"innerConeAngle":0.25,"outerConeAngle":0.75}}]}}}""";
        List<Light> lights = read(text).lights();
        assertEquals(List.of(Light.Kind.DISTANT, Light.Kind.POINT, Light.Kind.SPOT),
                lights.stream().map(Light::kind).toList());
        assertEquals(new Rgb(100, 50, 0), lights.get(0).power());
        assertEquals(-1, lights.get(0).direction().y(), 1e-12);
        assertEquals("n", lights.get(0).name());
        assertEquals("bulb", lights.get(1).name());
        assertEquals(Rgb.grey(40), lights.get(1).power());
        assertEquals(1, lights.get(1).range(), "candela are lux at a distance of 1");
        assertEquals(1, lights.get(1).position().x(), 1e-12);
        assertEquals(.75, lights.get(2).cone());
        assertEquals(.5, lights.get(2).edge());
        assertEquals(0, GltfReader.read(folder.resolve("a.gltf"), ReadOptions.defaults().withLights(
                ReadOptions.Lights.IGNORE), told::add).lights().size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"'intensity':-5", "'intensity':5,'color':[-1,0,-0.5]"})
    void negativeLights_areDark_andTheUserIsTold(String written) throws IOException {
        String text = square("", ",'extensions':{'KHR_lights_punctual':{'light':0}}", PAINT);
        String light = ",'extensions':{'KHR_lights_punctual':{'lights':[{'type':'point'," + written + "}]}}}";
        Scene scene = read(text.substring(0, text.length() - 1) + light.replace('\'', '"'));
        assertEquals(List.of(), scene.lights());
        assertEquals(1, told.stream()
                .filter(line -> line.contains("negative intensities and colors of lights count as 0")).count(),
                told::toString);
    }

    /** As with LightWave, although lights are ignored; the emission is photometric, as the scene is. */
    @Test
    void lightsThatLuminairesReplace_areKept() throws IOException {
        String text = square("", ",'extensions':{'KHR_lights_punctual':{'light':0}},'children':[1]},"
                + "{'extensions':{'KHR_lights_punctual':{'light':1}}", "{'emissiveFactor':[1,1,1]}");
        Path file = Files.writeString(folder.resolve("a.gltf"), text.substring(0, text.length() - 1) + """
                ,"extensions":{"KHR_lights_punctual":{"lights":[
                {"type":"point","name":"bulb"},{"type":"point","name":"other"}]}}}""");
        Scene scene = GltfReader.read(file, ReadOptions.defaults().withLights(ReadOptions.Lights.IGNORE)
                .withLuminaires(Map.of("bulb", Path.of("bulb.ies"))), told::add);
        assertEquals(List.of("bulb"), scene.lights().stream().map(Light::name).toList());
        assertEquals(Rgb.grey(Math.PI), scene.surface(0).exitance());
    }

    /** A placeholder: the luminaire takes its place and its colour. */
    @Test
    void lightOfIntensity0_isKeptWhereALuminaireReplacesIt() throws IOException {
        String text = square("", ",'extensions':{'KHR_lights_punctual':{'light':0}}", PAINT);
        Path file = Files.writeString(folder.resolve("a.gltf"), text.substring(0, text.length() - 1) + """
                ,"extensions":{"KHR_lights_punctual":{"lights":[
                {"type":"point","name":"bulb","intensity":0,"color":[1,0.5,0.25]}]}}}""");
        assertEquals(0, GltfReader.read(file, ReadOptions.defaults(), told::add).lights().size());
        assertEquals(new Rgb(1, .5, .25), GltfReader.read(file, ReadOptions.defaults().withLuminaires(
                Map.of("bulb", Path.of("bulb.ies"))), told::add).lights().get(0).power());
    }

    /** The extension alone is no light, nor is a light that no node has. */
    @Test
    void sceneWithoutLights_isNotPhotometric() throws IOException {
        for (String lights : List.of("", "{\"type\":\"point\"}")) {
            String text = square("", "", "{'emissiveFactor':[1,1,1]}");
            Scene scene = read(text.substring(0, text.length() - 1)
                    + ",\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[" + lights + "]}}}");
            assertEquals(Rgb.grey(1), scene.surface(0).exitance());
            assertFalse(scene.units().isPhotometric());
        }
    }

    @Test
    void luminaires_makeTheEmissionOfTheSceneALuminance() throws IOException {
        Path file = Files.writeString(folder.resolve("a.gltf"), square("", "", "{'emissiveFactor':[1,1,1]}"));
        assertEquals(Rgb.grey(1), GltfReader.read(file, ReadOptions.defaults(), told::add).surface(0).exitance());
        assertEquals(Rgb.grey(Math.PI), GltfReader.read(file, ReadOptions.defaults().withLuminaires(
                Map.of("0,2,0", Path.of("bulb.ies"))), told::add).surface(0).exitance());
    }

    @Test
    void camera_looksAlongMinusZ() throws IOException {
        String text = square("", ",'children':[1]},{'camera':0,'translation':[0,0,9]", PAINT);
        Camera camera = read(text.substring(0, text.length() - 1) + """
                ,"cameras":[{"type":"perspective","perspective":{"yfov":0.8,"aspectRatio":1.5,"znear":0.1}}]}""")
                .camera().orElseThrow();
        assertEquals(new Vec3(0, 0, 9), camera.position());
        assertEquals(-1, camera.forward().z(), 1e-12);
        assertEquals(.4, camera.verticalHalfAngle(), 1e-12);
        assertEquals(1.5, camera.aspect());
    }

    /** The square with a skin: its lower corners follow a joint at the origin, its upper ones another at (0, 2, 0). */
    private Scene skinned(float... weights) throws IOException {
        int bound = model.floats("MAT4", 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,
                1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1);
        int joints = model.accessor("VEC4", 5121, 4, ",\"bufferView\":" + model.view(new byte[] {
            0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 0));
        String text = model.one("'POSITION':" + model.floats("VEC3", Model.SQUARE) + ",'JOINTS_0':" + joints
                + ",'WEIGHTS_0':" + model.floats("VEC4", weights), ",'mode':6,'material':0",
                ",'skin':0,'translation':[100,0,0],'children':[1,2]},"
                + "{'translation':[-100,0,0]},{'translation':[-100,2,0]", PAINT);
        return read(text.substring(0, text.length() - 1) + ",\"skins\":[{\"joints\":[1,2],"
                + "\"inverseBindMatrices\":" + bound + "}]}");
    }

    /** The second joint stands twice as high as it was bound, and its vertices too; the node's place does not count. */
    @Test
    void skins_standAsTheirJointsDo() throws IOException {
        Scene scene = skinned(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0);
        assertEquals(2, scene.area(), 1e-6);
        assertEquals(0, scene.corner(0, 2).length(), 1e-6);
    }

    @Test
    void verticesWithoutWeights_stayInTheirPlace() throws IOException {
        Scene scene = skinned(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0);
        assertEquals(List.of(), told);
        assertEquals(1.5, scene.area(), 1e-6, "one of the upper corners stays below");
    }

    @Test
    void morphs_haveTheWeightsThatTheyRestAt() throws IOException {
        int target = model.floats("VEC3", 0, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0, 0);
        String text = model.one("'POSITION':" + model.floats("VEC3", Model.SQUARE),
                ",'mode':6,'targets':[{'POSITION':" + target + "}]", "", PAINT);
        assertEquals(1, read(text).area(), 1e-12);
        assertEquals(2, read(text.replace("\"name\":\"m\"", "\"weights\":[0.5]")).area(), 1e-6);
        assertEquals(3, read(text.replace("\"name\":\"n\"", "\"weights\":[1]")).area(), 1e-6);
    }

    @Test
    void binaries_andFilesBesideThem_areRead() throws IOException {
        byte[] positions = Model.bytes(0, 0, 0, 1, 0, 0, 0, 1, 0);
        String json = """
                {"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
                "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[
                {"type":"VEC3","componentType":5126,"count":3,"bufferView":0}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36%s}]}""";
        byte[] text = json.formatted("").getBytes(StandardCharsets.UTF_8);
        text = Arrays.copyOf(text, text.length + 3 & ~3);
        ByteBuffer glb = ByteBuffer.allocate(28 + text.length + 36).order(ByteOrder.LITTLE_ENDIAN);
        glb.putInt(0x46546C67).putInt(2).putInt(glb.capacity()).putInt(text.length).putInt(0x4E4F534A)
                .put(new String(text, StandardCharsets.UTF_8).replace('\0', ' ').getBytes(StandardCharsets.UTF_8))
                .putInt(36).putInt(0x004E4942).put(positions);
        assertEquals(.5, read(Files.write(folder.resolve("b.glb"), glb.array())).area(), 1e-12);
        String beside = json.formatted(",\"uri\":\"Data%20of%20b.bin\"");
        assertEquals("a.gltf, JSON /buffers/0/uri: expected a file beside it, got \"Data%20of%20b.bin\"",
                refused(beside));
        Files.write(folder.resolve("data of B.BIN"), positions);
        assertEquals(.5, read(beside).area(), 1e-12);
        assertTrue(refused(json.formatted(",\"uri\":\"../../../../etc/passwd\"")).contains("a file beside it"));
    }

    @Test
    void whatIsNotRead_isRefusedByName() throws IOException {
        String text = square("", "", PAINT);
        assertTrue(refused(text.replace("\"scene\":0", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]"))
                .endsWith("got KHR_draco_mesh_compression"));
        assertEquals("a.gltf, JSON /asset/version: expected glTF version 2.0, got \"1.0\"",
                refused(text.replace("\"2.0\"", "\"1.0\"")));
        assertTrue(refused(text.replace("{\"version\"", "{\"extras\":{\"radiosity\":{}},\"version\""))
                .endsWith("got a scene file of this program; give what it was made from"));
        assertEquals("a.gltf, JSON /nodes/0: expected a node with one parent, got several",
                refused(text.replace("\"name\":\"n\"", "\"children\":[0]")));
        assertTrue(refused(text.replace("\"count\":4", "\"count\":5")).contains("expected elements within 48 bytes"));
        assertTrue(refused(text.replace("\"count\":4", "\"byteOffset\":9223372036854775807,\"count\":4"))
                .contains("expected elements within 48 bytes"));
        String broken = refused("{\"asset\":{\"version\":\"2.0\"}");
        assertTrue(broken.contains("expected JSON") && broken.contains("(start marker at line: 1, column: 1)"), broken);
        assertTrue(refused(text.replace("\"count\":4", "\"count\":2000000000")).contains("/accessors/0"));
        assertEquals(1, read(text.replace("\"scene\":0", "\"extensionsUsed\":[\"KHR_draco_mesh_compression\"]")).area(),
                1e-12);
    }

    @Test
    void namesThatMaterialsShare_getNumbers_andWhiteIsDarkenedWithAWord() throws IOException {
        String text = model.text("'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}]", "'meshes':[{'primitives':["
                + "{'attributes':{'POSITION':" + model.floats("VEC3", Model.SQUARE) + "},'mode':6,'material':0},"
                + "{'attributes':{'POSITION':0},'mode':6,'material':1}]}]",
                "'materials':[{'name':'a'},{'name':'a','alphaMode':'BLEND'}]");
        assertEquals(List.of("a", "a#1"), read(text).surfaces().stream().map(Surface::name).toList());
        assertEquals(List.of("a.gltf: reflectances of 1 and more are taken as 0.9999: a, a#1 (2 times)",
                "a.gltf: transparent surfaces are taken as opaque (see --leave-out): a#1"), told);
    }

    /** Such files may name the extension as used only, though they have no data without it. */
    @Test
    void compressionWithoutPlainData_isRefusedByName() throws IOException {
        String plain = square("", "", PAINT);
        String draco = ",'extensions':{'KHR_draco_mesh_compression':{'bufferView':0,'attributes':{'POSITION':0}}}";
        String text = model.one("'POSITION':" + model.accessor("VEC3", 5126, 3, ""), draco, "", PAINT);
        assertEquals("a.gltf, JSON /meshes/0/primitives/0: expected data without compression (export without it), got"
                + " KHR_draco_mesh_compression", refused(text));
        assertEquals(1, read(square(draco, "", PAINT)).area(), 1e-12, "data beside the compressed");
        for (String meshopt : new String[] {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
            String both = plain.replaceFirst("\"bufferViews\":\\[\\{", "$0\"extensions\":{\"" + meshopt
                    + "\":{}},");
            assertEquals(1, read(both).area(), 1e-12);
            assertEquals("a.gltf, JSON /bufferViews/0: expected data without compression (export without it), got "
                    + meshopt, refused(both.replaceFirst("\"byteLength\":48", "\"byteLength\":4800")));
        }
    }

    /** A square of 8 x 8 m, 5400 km from the origin along y, where floats are half a metre apart. */
    @Test
    void floatsFarFromTheOrigin_areWarnedOf_evenWhereTheNodeBringsThemBack() throws IOException {
        float[] far = {0, 5.4e6f, 0, 8, 5.4e6f, 0, 8, 5.4e6f + 8, 0, 0, 5.4e6f + 8, 0};
        read(model.one("'POSITION':" + model.floats("VEC3", far), ",'mode':6,'material':0",
                ",'translation':[0,-5400000,0]", PAINT));
        assertEquals(List.of("a.gltf: coordinates are as coarse as 0.044 of the scene's size; move the model to the origin"
                + " before it is written as floats"), told);
        told.clear();
        read(square("", ",'translation':[0,5400000,0]", PAINT));
        assertEquals(List.of(), told, "the place of a node is exact");
    }

    private Optional<Specular> specular(String material) throws IOException {
        return read(square("", "", "{" + material + "}")).surface(0).specular();
    }

    private static String rough(double metallic, double roughness) {
        return "'pbrMetallicRoughness':{'baseColorFactor':[0.5,0.25,0.75,1],'metallicFactor':" + metallic
                + ",'roughnessFactor':" + roughness + "}";
    }

    private static String glass(double factor, String more) {
        return ",'extensions':{'KHR_materials_transmission':{'transmissionFactor':" + factor + "}" + more + "}";
    }

    @Test
    void metalAndPolish_shineWhereTheyAreSmooth() throws IOException {
        Rgb colour = new Rgb(.5, .25, .75);
        assertEquals(new Specular(colour, Rgb.BLACK, 0, .1, 1.5, true), specular(rough(1, .1)).orElseThrow());
        Specular polish = specular(rough(0, 0) + ",'extensions':{'KHR_materials_ior':{'ior':2}}").orElseThrow();
        assertEquals(1. / 9, polish.reflectance().r(), 1e-12);
        assertEquals(8. / 9, polish.diffuse(), 1e-12);
        assertEquals(2, polish.index());
        assertEquals(Optional.empty(), specular(rough(1, .5)));
        assertEquals(Optional.empty(), specular("'pbrMetallicRoughness':{}"));
        assertEquals(Optional.empty(), specular("'name':'plain'"));
        assertEquals(Optional.empty(), specular(rough(1, 0).replace("'metallicFactor'",
                "'metallicRoughnessTexture':{'index':0},'metallicFactor'")));
    }

    @Test
    void transmission_isASheetOrASolid() throws IOException {
        Specular sheet = specular(rough(0, 1) + glass(.5, "")).orElseThrow();
        assertEquals(.96 * .5 * .25, sheet.transmittance().g(), 1e-12);
        assertEquals(.96 * .5, sheet.diffuse(), 1e-12);
        assertTrue(sheet.thin());
        assertEquals(List.of("a.gltf: transparent surfaces let no light through; pictures show what is behind them:"
                + " material 0"), told);
        assertEquals(false, specular(rough(0, 0) + glass(1, ",'KHR_materials_volume':{'thicknessFactor':1}"))
                .orElseThrow().thin());
    }

    @Test
    void hostileFactors_areLimitedOrRefused() throws IOException {
        assertEquals(new Rgb(.5, .25, .75), specular(rough(1e9, -1e9)).orElseThrow().reflectance());
        assertEquals(Optional.empty(), specular(rough(-1, 1e9) + glass(-3, "")));
        assertEquals(Specular.MOST_INDEX, specular(rough(0, 0) + ",'extensions':{'KHR_materials_ior':{'ior':0}}")
                .orElseThrow().index());
        assertEquals("a.gltf, JSON /materials/0/extensions/KHR_materials_ior/ior: expected an index of refraction of at"
                + " least 1, or 0, got 0.5",
                refused(square("", "", "{'extensions':{'KHR_materials_ior':{'ior':0.5}}}")));
    }
}
