package radiosity.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.output.image.SurfaceMaps;
import radiosity.scene.MaterialSample;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/**
 * The models of Debian's package assimp-testmodels, among them sample models of Khronos, broken ones, and files of some
 * forty other kinds: each is read or refused in a line, and what is read has the areas and colours that other readers
 * find (read_models.py beside sample-models.csv).
 */
@Tag("slow")
@EnabledIf(value = "areInstalled", disabledReason = "needs Debian's package assimp-testmodels, which is not installed")
class SampleModelsTest {

    private static final Path FOLDER = Path.of("/usr/share/assimp/models");
    private static final String TABLE = "/radiosity/input/sample-models.csv";
    private static final double WITHIN = 1e-6;
    /** Of means of images: two ways to sample them. */
    private static final double IMAGE_WITHIN = 5e-3;
    private static final int PARTS = 64;

    static boolean areInstalled() {
        return Files.isDirectory(FOLDER);
    }

    private static Scene read(Path file) throws IOException {
        return SurfaceMaps.read(SceneReader.read(file, ReadOptions.defaults(), warning -> { }), false, warning -> { });
    }

    @TestFactory
    Stream<DynamicTest> everyFile_isReadOrRefusedInALine() throws IOException {
        return Files.walk(FOLDER).filter(Files::isRegularFile).sorted()
                .map(file -> DynamicTest.dynamicTest(FOLDER.relativize(file).toString(), () -> {
                    try {
                        assertTrue(read(file).triangles() > 0);
                    } catch (SceneFormatException e) {
                        assertFalse(e.getMessage().contains("\n"), e.getMessage());
                        assertTrue(e.getMessage().startsWith(file.getFileName().toString()), e.getMessage());
                    }
                }));
    }

    @ParameterizedTest
    @CsvFileSource(resources = TABLE)
    void areasAndColours_areThoseOfOtherReaders(ArgumentsAccessor row) throws IOException {
        Scene scene = read(FOLDER.resolve(row.getString(0)));
        assertEquals(row.getInteger(1), scene.triangles());
        double[] found = new double[7];
        for (int t = 0; t < scene.triangles(); t++) {
            MaterialSample mean = mean(scene, t);
            found[0] += scene.area(t);
            for (int c = 0; c < 3; c++) {
                found[1 + c] += scene.area(t) * mean.reflectance().channel(c);
                found[4 + c] += scene.area(t) * mean.exitance().channel(c);
            }
        }
        for (int i = 0; i < found.length && row.getString(2 + i) != null; i++) {
            double within = i > 0 && row.getString(9) != null ? IMAGE_WITHIN : WITHIN;
            assertEquals(row.getDouble(2 + i), found[i], within * row.getDouble(2 + i), "column " + (2 + i));
        }
    }

    private static MaterialSample mean(Scene scene, int t) {
        Vec3 a = scene.corner(t, 0);
        Vec3 u = scene.corner(t, 1).minus(a).times(1.0 / PARTS);
        Vec3 v = scene.corner(t, 2).minus(a).times(1.0 / PARTS);
        if (scene.surface(t).maps().isEmpty()) {
            return scene.meanMaterial(t, a, scene.corner(t, 1), scene.corner(t, 2));
        }
        MaterialSample sum = null;
        for (int i = 0; i < PARTS; i++) {
            for (int j = 0; j < PARTS - i; j++) {
                Vec3 p = a.plus(u.times(i)).plus(v.times(j));
                sum = plus(sum, scene.meanMaterial(t, p, p.plus(u), p.plus(v)));
                if (i + j < PARTS - 1) {
                    sum = plus(sum, scene.meanMaterial(t, p.plus(u), p.plus(u).plus(v), p.plus(v)));
                }
            }
        }
        double part = 1.0 / (PARTS * PARTS);
        return new MaterialSample(sum.exitance().times(part), sum.reflectance().times(part));
    }

    private static MaterialSample plus(MaterialSample a, MaterialSample b) {
        return a == null ? b
                : new MaterialSample(a.exitance().plus(b.exitance()), a.reflectance().plus(b.reflectance()));
    }

    @ParameterizedTest
    @CsvSource({
        "glTF2/draco/2CylinderEngine.gltf, got KHR_draco_mesh_compression",
        "glTF2/BoxTextured-glTF-techniqueWebGL/BoxTextured.gltf, got KHR_technique_webgl",
        "glTF2/RecursiveNodes/RecursiveNodes.gltf, 'expected a node with one parent, got several'",
        "glTF2/MissingBin/BoxTextured.gltf, 'expected a file beside it, got \"BoxTextured0.bin\"'",
        "glTF2/SchemaFailures/sceneWrongType.gltf, 'JSON /scene: expected a whole number, got \"hello\"'",
        "glTF/BoxTextured-glTF-Binary/BoxTextured.glb, 'expected glTF version 2, got 1'",
        "glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_00.gltf, expected at least one polygon",
        "Collada/duck.dae, got a Collada file (DAE)", "FBX/box.fbx, got an FBX file",
        "BLEND/box.blend, got a Blender file"})
    void others_areRefusedByName(String file, String reason) {
        SceneFormatException refused = assertThrows(SceneFormatException.class,
                () -> read(FOLDER.resolve(file)));
        assertTrue(refused.getMessage().contains(reason), refused.getMessage());
    }
}
