package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;

/** One scene in several formats is one scene. */
class VariantsTest {

    @ParameterizedTest
    @ValueSource(strings = {"bright_ratio", "cornell_blocks", "cornell_empty", "corridor30", "high_albedo",
        "many_occluders", "thin_wall", "touching", "two_room"})
    void truthScenes_areTheSameInAllVariants(String name) throws IOException {
        Scene first = read(Shared.path("truth/lightwave/" + name + ".lws"));
        for (String variant : List.of("_lwo2", "_v1")) {
            Scene other = read(Shared.path("truth/lightwave/" + name + variant + ".lws"));
            assertArrayEquals(first.points(), other.points());
            assertArrayEquals(first.corners(), other.corners());
            assertArrayEquals(first.surfaceOf(), other.surfaceOf());
            assertSameSurfaces(first, other, 1e-6);
        }
    }

    private static Scene read(Path file) throws IOException {
        List<String> warnings = new ArrayList<>();
        Scene scene = LightWaveReader.read(file, ReadOptions.defaults(), warnings::add);
        assertEquals(List.of(), warnings);
        return scene;
    }

    private static void assertSameSurfaces(Scene first, Scene other, double tolerance) {
        assertEquals(first.surfaces().size(), other.surfaces().size());
        for (int i = 0; i < first.surfaces().size(); i++) {
            Surface a = first.surfaces().get(i);
            Surface b = other.surfaces().get(i);
            assertEquals(a.name(), b.name());
            for (int c = 0; c < 3; c++) {
                assertEquals(a.reflectance().channel(c), b.reflectance().channel(c), tolerance);
                assertEquals(a.exitance().channel(c), b.exitance().channel(c), tolerance * (1 + a.exitance().max()));
            }
        }
    }
}
