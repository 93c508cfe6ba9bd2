package radiosity;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Hierarchy;
import radiosity.scene.ImageMap;
import radiosity.scene.Light;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;

/** The front of the library, as a program calls it that knows nothing of what is behind: wrong values, and stops. */
class RadiosityTest {

    private static final Surface WHITE = new Surface("white", Rgb.BLACK, Rgb.grey(.5), false, List.of());
    private static final Surface LAMP = new Surface("lamp", Rgb.grey(10), Rgb.BLACK, false, List.of());

    private static SceneBuilder room() {
        Vec3[] c = new Vec3[8];
        for (int i = 0; i < 8; i++) {
            c[i] = new Vec3(i & 1, i >> 1 & 1, i >> 2 & 1);
        }
        return new SceneBuilder().polygon(LAMP, new Vec3(.4, .9, .4), new Vec3(.6, .9, .4), new Vec3(.6, .9, .6),
                        new Vec3(.4, .9, .6))
                .polygon(WHITE, c[0], c[4], c[5], c[1]).polygon(WHITE, c[2], c[3], c[7], c[6])
                .polygon(WHITE, c[0], c[2], c[6], c[4]).polygon(WHITE, c[1], c[5], c[7], c[3])
                .polygon(WHITE, c[0], c[1], c[3], c[2]).polygon(WHITE, c[4], c[6], c[7], c[5]);
    }

    private static Raster raster(float... rgb) {
        return new Raster(rgb.length / 3, 1, rgb, ImageMap.Wrap.REPEAT, ImageMap.Wrap.REPEAT, Rgb.BLACK);
    }

    @ParameterizedTest
    @ValueSource(floats = {-1, Float.NaN, Float.POSITIVE_INFINITY})
    void imagesOfNegativeLight_andOfNoNumbers_areRefused(float value) {
        assertThrows(IllegalArgumentException.class, () -> raster(0, 0, 0, 1, value, 0));
    }

    /** The mean of the image is that of a possible surface. */
    @Test
    void imagesThatReflectMoreThanArrives_areRefused() {
        Raster image = raster(1.9f, 0, 0, 0, 0, 0);
        assertThrows(IllegalArgumentException.class,
                () -> WHITE.with(new Surface.Maps(Optional.empty(), Optional.of(image))));
        assertEquals(.95, LAMP.with(new Surface.Maps(Optional.of(image), Optional.empty())).exitance().r(), 1e-6);
    }

    @Test
    void settingsOutOfTheirRange_areRefused() {
        for (double wrong : new double[] {-1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> new RadiositySettings(wrong, 0, 1, Schedule.PREDICT));
            assertThrows(IllegalArgumentException.class,
                    () -> new RadiositySettings(0, 0, 1, Schedule.PREDICT, wrong, 1));
        }
        assertThrows(IllegalArgumentException.class, () -> new RadiositySettings(0, 0, 1, Schedule.PREDICT, 1, -1));
        assertThrows(IllegalArgumentException.class, () -> new RadiositySettings(0, -1, 1, Schedule.PREDICT));
        assertThrows(IllegalArgumentException.class,
                () -> new RadiositySettings(0, Integer.MAX_VALUE, 1, Schedule.PREDICT));
        assertThrows(IllegalArgumentException.class, () -> new RadiositySettings(0, 0, -1, Schedule.PREDICT));
        assertThrows(IllegalArgumentException.class, () -> new RadiositySettings(0, 0, 1, null));
        assertThrows(IllegalArgumentException.class, () -> RadiositySettings.defaults().accurate(0));
        assertThrows(IllegalArgumentException.class, () -> RadiositySettings.defaults().accurate(Double.NaN));
        Radiosity paper = Radiosity.of(room().scene("room")).settings(new RadiositySettings(0, 4,
                Double.POSITIVE_INFINITY, Schedule.PAPER));
        assertThrows(IllegalArgumentException.class, () -> paper.accuracy(.1), "an error that nothing looks at");
    }

    @Test
    void textureCoordinates_areFinite_orNoneOfATriangle() {
        Scene plain = room().scene("room");
        float[] coordinates = new float[6 * plain.triangles()];
        coordinates[0] = Float.NaN;
        textured(plain, coordinates);
        coordinates[9] = Float.NaN;
        assertThrows(IllegalArgumentException.class, () -> textured(plain, coordinates));
        coordinates[9] = Float.POSITIVE_INFINITY;
        assertThrows(IllegalArgumentException.class, () -> textured(plain, coordinates));
    }

    private static Scene textured(Scene plain, float[] coordinates) {
        return new Scene("textured", plain.points(), plain.corners(), plain.surfaceOf(), plain.surfaces(), List.of(),
                Optional.empty(), coordinates, new float[0], Hierarchy.NONE);
    }

    @Test
    void layersOfMoreLampsThanCanBeKeptApart_areRefused() {
        SceneBuilder many = room();
        for (int i = 0; i < RadiositySettings.MOST_LAMPS; i++) {
            many.light(new Light("light " + i, Light.Kind.POINT, Rgb.grey(1), new Vec3(.5, .5, .5), new Vec3(0, -1, 0),
                    Vec3.ZERO, Vec3.ZERO, 1, 0, 0));
        }
        Radiosity radiosity = Radiosity.of(many.scene("many")).layers();
        assertThrows(IllegalArgumentException.class, () -> radiosity.run(progress -> true));
    }

    /** Who stops does not want to wait for an estimate. */
    @Test
    void stoppedCalculation_isNotEstimated() throws IOException {
        Radiosity radiosity = Radiosity.of(room().scene("room")).accuracy(.1).threads(1);
        assertTrue(radiosity.run(progress -> true).certificate().isPresent());
        assertFalse(radiosity.run(progress -> progress.shots() == 0).certificate().isPresent());
    }

    @Test
    void exceptionsOfTheListener_areThrownToTheCaller_whereverItIsCalled() {
        Radiosity radiosity = Radiosity.of(room().scene("room")).accuracy(.02).threads(1);
        for (int call = 1; call < 6; call++) {
            CancellationException mine = new CancellationException("mine");
            int[] left = {call};
            assertSame(mine, assertThrows(CancellationException.class, () -> radiosity.run(progress -> {
                if (--left[0] == 0) {
                    throw mine;
                }
                return true;
            })), "call " + call);
        }
    }

    @Test
    void filesOfAnInterruptedThread_areNotWritten_andTheExceptionSaysWhy(@TempDir Path folder) throws IOException {
        RadiosityResult result = Radiosity.of(room().scene("room")).accuracy(.1).threads(1).run(progress -> true);
        Thread.currentThread().interrupt();
        try {
            assertThrows(ClosedByInterruptException.class, () -> result.writeScene(folder.resolve("a.scene")));
        } finally {
            assertTrue(Thread.interrupted());
        }
        try (var files = Files.list(folder)) {
            assertEquals(List.of(), files.toList());
        }
    }

    /** The file is as good as the result from which it was written. */
    @Test
    void calculation_goesOnFromASceneFile_andSoDoesAChange(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("a.scene");
        Scene room = room().scene("room");
        Radiosity.of(room).accuracy(.05).run(progress -> progress.shots() < 20).writeScene(file);
        RadiosityResult whole = Radiosity.of(room).accuracy(.05).run(progress -> true);
        RadiosityResult resumed = Radiosity.of(room).accuracy(.05).resume(file).run(progress -> true);
        assertEquals(whole.solution().state().sha256(), resumed.solution().state().sha256());
        resumed.writeScene(file);
        Scene lit = room().light(new Light("bulb", Light.Kind.POINT, Rgb.grey(1), new Vec3(.5, .5, .5),
                new Vec3(0, -1, 0), Vec3.ZERO, Vec3.ZERO, 1, 0, 0)).scene("room");
        List<String> lines = new ArrayList<>();
        RadiosityResult fromFile = Radiosity.of(lit).accuracy(.05).change(file, lines::add).run(progress -> true);
        RadiosityResult fromResult = Radiosity.of(lit).accuracy(.05).change(whole.solution(), lines::add)
                .run(progress -> true);
        assertEquals(fromResult.solution().state().sha256(), fromFile.solution().state().sha256());
        assertEquals(List.of(), lines);
    }

    @Test
    void imagesOfABuiltScene_lieOnThePolygonsThatAreGivenCoordinates() {
        Surface wood = WHITE.with(new Surface.Maps(Optional.empty(), Optional.of(raster(.2f, .2f, .2f, .8f, .8f, .8f))));
        Vec3[] square = {new Vec3(0, 0, 0), new Vec3(0, 0, 1), new Vec3(1, 0, 1), new Vec3(1, 0, 0)};
        double[] u = {0, 0, 1, 1};
        double[] v = {0, 1, 1, 0};
        Scene scene = new SceneBuilder().polygon(LAMP, square).polygon(wood, square, u, v).polygon(wood, square)
                .scene("table");
        assertFalse(scene.hasImages(1));
        assertTrue(scene.hasImages(2) && scene.hasImages(3));
        assertFalse(scene.hasImages(4));
        assertEquals(.2, scene.material(2, new Vec3(.25, 0, .5)).reflectance().r(), 1e-6);
        assertEquals(.8, scene.material(3, new Vec3(.75, 0, .5)).reflectance().r(), 1e-6);
        assertEquals(.5, scene.material(4, new Vec3(.8, 0, .5)).reflectance().r(), 1e-6);
        assertEquals(0, room().scene("room").textureCoordinates().length);
        assertThrows(IllegalArgumentException.class,
                () -> new SceneBuilder().polygon(wood, square, u, new double[] {0, 1, 1, Double.NaN}));
        assertThrows(IllegalArgumentException.class, () -> new SceneBuilder().polygon(wood, square, u, new double[3]));
    }

    @ParameterizedTest
    @ValueSource(ints = {-5, 0, Integer.MAX_VALUE})
    void picturesOfNoWidth_andOfMorePixelsThanThereCanBe_areRefused(int width, @TempDir Path folder) throws IOException {
        RadiosityResult result = Radiosity.of(room().scene("room")).accuracy(.1).threads(1).run(progress -> true);
        assertThrows(IllegalArgumentException.class, () -> result.writePicture(folder.resolve("a.png"), width));
    }

    @Test
    void directions_mayBeOfAnyLength() {
        for (double length : new double[] {1e-310, 1e-300, 1e-160, 1, 1e160, 1e300}) {
            Vec3 unit = new Vec3(3 * length, 0, 4 * length).unit();
            assertArrayEquals(new double[] {.6, 0, .8}, new double[] {unit.x(), unit.y(), unit.z()}, 1e-6,
                    "length " + length);
        }
        assertEquals(5e300, new Vec3(3e300, 0, 4e300).length(), 1e288);
        assertEquals(0, Vec3.ZERO.unit().length());
    }
}
