package radiosity.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.protocol.SceneBytes;
import radiosity.protocol.Wire;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;

/** The resolution to which the images of a scene are brought before the calculation. */
class ImageBudgetTest {

    /** A triangle for each of so many surfaces, whose reflectance is an image of size x size pixels. */
    private static Scene scene(int surfaces, int size) {
        float[] rgb = new float[3 * size * size];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i / 3 % size < size / 4 ? .75f : .25f;
        }
        Raster image = new Raster(size, size, rgb, ImageMap.Wrap.REPEAT, ImageMap.Wrap.REPEAT, Rgb.BLACK);
        Surface surface = new Surface("wood", Rgb.BLACK, Rgb.BLACK, false, List.of())
                .with(new Surface.Maps(Optional.empty(), Optional.of(image)));
        double[] points = new double[9 * surfaces];
        float[] coordinates = new float[6 * surfaces];
        int[] corners = new int[3 * surfaces];
        int[] surfaceOf = new int[surfaces];
        for (int s = 0; s < surfaces; s++) {
            points[9 * s + 3] = 1;
            points[9 * s + 7] = 1;
            points[9 * s + 2] = s;
            points[9 * s + 5] = s;
            points[9 * s + 8] = s;
            coordinates[6 * s + 2] = 1;
            coordinates[6 * s + 5] = 1;
            Arrays.setAll(corners, i -> i);
            surfaceOf[s] = s;
        }
        return new Scene("textured", points, corners, surfaceOf, Collections.nCopies(surfaces, surface),
                List.of(), Optional.empty(), coordinates, new float[0], Hierarchy.NONE);
    }

    private static int width(Scene scene) {
        return scene.surfaces().get(0).maps().reflectance().orElseThrow().width();
    }

    @Test
    void smallImages_stay() {
        Scene small = scene(2, 1024);
        assertSame(small, ImageBudget.forLight(small));
    }

    @Test
    void aLargeImage_isHalved_andKeepsItsMean() {
        Scene large = scene(1, 2048);
        Scene reduced = ImageBudget.forLight(large);
        assertEquals(1024, width(reduced));
        assertEquals(.375, reduced.surfaces().get(0).reflectance().r(), 1e-6);
        assertEquals(large.surfaces().get(0).reflectance(), reduced.surfaces().get(0).reflectance());
    }

    @Test
    void manyImages_areHalvedTogether() {
        Scene reduced = ImageBudget.forLight(scene(5, 1024));
        assertEquals(512, width(reduced));
        assertSame(reduced, ImageBudget.forLight(reduced), "a host is sent what the master has reduced");
    }

    /** Images are read one after another, and those read first are reduced where later ones need the room. */
    @Test
    void imagesThatComeOneByOne_areThoseReducedTogether() {
        List<Surface> all = scene(5, 64).surfaces();
        ImageBudget budget = new ImageBudget(64 * 64, 2 * 64 * 64);
        List<Surface> some = new ArrayList<>();
        List<Integer> widths = new ArrayList<>();
        for (Surface next : all) {
            some.add(next);
            some = new ArrayList<>(budget.reduce(some));
            widths.add(some.get(0).maps().reflectance().orElseThrow().width());
        }
        assertEquals(List.of(64, 64, 32, 32, 32), widths);
        assertTrue(some.stream().allMatch(surface -> surface.maps().reflectance().orElseThrow().width() == 32));
        assertEquals(32 * 32, budget.limit());
    }

    /** The master makes its mesh from the whole images, hosts make theirs from those that were sent. */
    @Test
    void hosts_haveTheMeshOfTheMaster() throws Exception {
        Scene large = scene(2, 2048);
        RadiositySettings settings = RadiositySettings.defaults();
        byte[] sent = SceneBytes.write(large, settings);
        assertTrue(sent.length < 3 * Float.BYTES * (2 << 20) + 10_000, sent.length + " bytes are sent");
        Scene there = SceneBytes.read(Wire.input(sent)).scene();
        assertEquals(new InitialMesh(large, settings).fingerprint(), new InitialMesh(there, settings).fingerprint());
    }
}
