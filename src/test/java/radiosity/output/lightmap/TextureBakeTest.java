package radiosity.output.lightmap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.ref.WeakReference;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.gltf.Handmade;
import radiosity.output.gltf.SceneFile;
import radiosity.output.gltf.SceneInfo;
import radiosity.output.image.Picture;
import radiosity.output.image.ToneMapping;
import radiosity.scene.ImageMap;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

@Tag("slow")
class TextureBakeTest {

    private static final double SAMPLES = 7.3;

    @TempDir
    Path folder;

    /** Light that rises evenly along every axis, as elements and textures both can carry it. */
    private static Rgb light(Vec3 p) {
        return new Rgb(1 + p.x(), 2 + p.y(), 3 + p.z());
    }

    private static Solution room() {
        return Handmade.room(new Vec3(-1, -1, -1), 3, TextureBakeTest::light).solution();
    }

    private static double channel(TextureBake.Baked baked, int c, double u, double v) {
        Picture texture = baked.radiosity();
        double x = u * texture.width() - 0.5;
        double y = v * texture.height() - 0.5;
        int i = (int) Math.floor(x);
        int j = (int) Math.floor(y);
        double sum = 0;
        for (int k = 0; k < 4; k++) {
            int texel = (j + k / 2) * texture.width() + i + k % 2;
            sum += texture.rgb()[3 * texel + c] * (k % 2 == 0 ? i + 1 - x : x - i) * (k / 2 == 0 ? j + 1 - y : y - j);
        }
        return sum;
    }

    private static List<TextureBake.Baked> bake(Solution solution, Vec3 origin, double samples) throws IOException {
        List<TextureBake.Baked> sides = new ArrayList<>();
        new TextureBake(solution, origin, samples).bake(sides::add);
        return sides;
    }

    /** Of textures that may take 805 MB each, none is kept while the next is made. */
    @Test
    void textures_areLeftToWhoTakesThem() throws IOException {
        List<WeakReference<Picture>> taken = new ArrayList<>();
        new TextureBake(room(), Vec3.ZERO, SAMPLES).bake(side -> {
            System.gc();
            assertTrue(taken.stream().allMatch(before -> before.get() == null), "kept after " + taken.size());
            taken.add(new WeakReference<>(side.radiosity()));
        });
        assertEquals(6, taken.size());
    }

    @Test
    void texture_holdsTheLightOfItsElements() throws IOException {
        List<TextureBake.Baked> sides = bake(room(), Vec3.ZERO, SAMPLES);
        assertEquals(6, sides.size());
        for (TextureBake.Baked side : sides) {
            for (int t = 0; t < side.positions().length / 9; t++) {
                assertLight(side, t, 1 / 3.0, 1 / 3.0, 1e-5);
                assertLight(side, t, 0.98, 0.01, 0.6 / SAMPLES);
                assertLight(side, t, 0, 0.5, 0.6 / SAMPLES);
            }
        }
    }

    /** At a point of a triangle by its weights; near an edge the padding may be off by half a texel. */
    private static void assertLight(TextureBake.Baked side, int t, double a, double b, double error) {
        double[] w = {a, b, 1 - a - b};
        double[] place = new double[2];
        double[] p = new double[3];
        for (int k = 0; k < 3; k++) {
            for (int i = 0; i < 3; i++) {
                p[i] += w[k] * side.positions()[9 * t + 3 * k + i];
            }
            place[0] += w[k] * side.places()[6 * t + 2 * k];
            place[1] += w[k] * side.places()[6 * t + 2 * k + 1];
        }
        Rgb b0 = light(new Vec3(p[0], p[1], p[2])).times(side.surface().reflectance());
        for (int c = 0; c < 3; c++) {
            assertEquals(b0.channel(c), channel(side, c, place[0], place[1]), error, side.surface().name());
        }
    }

    @Test
    void plainParts_keepApart() throws IOException {
        Handmade made = new Handmade();
        int surface = made.surface("s", 0.5);
        Vec3 x = new Vec3(1, 0, 0);
        Vec3 y = new Vec3(0, 1, 0);
        made.grid(surface, Vec3.ZERO, x, y, 2, 2, p -> Rgb.grey(2));
        made.grid(surface, new Vec3(5, 0, 0), x, y, 2, 2, p -> Rgb.grey(20));
        TextureBake.Baked baked = bake(made.solution(), Vec3.ZERO, 4).get(0);
        for (int k = 0; k < baked.places().length / 2; k++) {
            double value = channel(baked, 0, baked.places()[2 * k], baked.places()[2 * k + 1]);
            assertEquals(baked.positions()[3 * k] < 5 ? 1 : 10, value, 1e-6, "a mixture of two parts");
        }
    }

    @Test
    void file_keepsTexturesBesideItsMeshes() throws IOException {
        Path file = folder.resolve("room.scene");
        Solution room = room();
        ToneMapping toneMapping = ToneMapping.automatic(room);
        SceneFile.write(file, room, Map.of(), Optional.empty(), toneMapping, OptionalDouble.of(SAMPLES));
        try (SceneFile read = SceneFile.open(file)) {
            assertEquals(6, read.meshes().size());
            assertEquals(6, read.textures().size());
            assertEquals(Optional.of(toneMapping), read.textureToneMapping());
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(read.textures().get(0).png()));
            assertTrue(image.getWidth() >= 3 * SAMPLES && image.getWidth() < 3 * SAMPLES + 6);
        }
        assertTrue(SceneInfo.lines(file).stream().anyMatch(line -> line.matches("surfaces +6: .*")));
    }

    @Test
    void tooManySamples_areRefused() {
        IOException error = assertThrows(IOException.class, () -> bake(room(), Vec3.ZERO, 1e4));
        assertTrue(error.getMessage().startsWith("-ut, surface floor: expected"), error.getMessage());
    }

    /** One surface in so many squares that lie apart, each with the whole of a large image. */
    private static Solution painted(int squares) {
        Handmade made = new Handmade();
        int surface = made.surface("painted", 0.5);
        for (int i = 0; i < squares; i++) {
            made.grid(surface, new Vec3(2 * i, 0, 0), new Vec3(1, 0, 0), new Vec3(0, 1, 0), 1, 1, p -> Rgb.grey(1));
        }
        Solution plain = made.solution();
        Scene scene = plain.scene();
        float[] places = new float[6 * scene.triangles()];
        for (int i = 0; i < 3 * scene.triangles(); i++) {
            Vec3 p = scene.corner(i / 3, i % 3);
            places[2 * i] = (float) (p.x() % 2);
            places[2 * i + 1] = (float) p.y();
        }
        Raster large = new Raster(1000, 1000, new float[3_000_000], ImageMap.Wrap.EDGE, ImageMap.Wrap.EDGE, Rgb.BLACK);
        Surface.Maps maps = new Surface.Maps(Optional.empty(), Optional.of(large));
        Scene mapped = new Scene(scene.name(), scene.points(), scene.corners(), scene.surfaceOf(),
                List.of(scene.surfaces().get(0).with(maps)), List.of(), Optional.empty(), places);
        return new Solution(mapped, 3, plain.positions(), plain.irradiance(), plain.corners(), plain.faceOf(), 0, 0, 0,
                plain.ledger(), SavedState.NONE);
    }

    @Test
    void image_isKeptAtFullSizeWhereThereIsRoom() throws IOException {
        Picture one = bake(painted(1), Vec3.ZERO, SAMPLES).get(0).radiosity();
        assertTrue(one.width() >= 1000 && one.width() < 1100, one.width() + " texels");
        Picture many = bake(painted(150), Vec3.ZERO, SAMPLES).get(0).radiosity();
        assertTrue(Math.max(many.width(), many.height()) <= 8192, many.width() + "x" + many.height());
    }

    /** A slat of a hundredth, of which a sample of the texture is a seventh. */
    @Test
    void surfaceNarrowerThanATexel_isNotBlack() throws IOException {
        Handmade made = new Handmade();
        made.grid(made.surface("slat", Rgb.BLACK, Rgb.grey(.5), false), Vec3.ZERO, new Vec3(.01, 0, 0),
                new Vec3(0, 1, 0), 1, 4, p -> Rgb.grey(3));
        TextureBake.Baked baked = bake(made.solution(), Vec3.ZERO, SAMPLES).get(0);
        for (int k = 0; k < baked.places().length / 2; k++) {
            assertEquals(1.5, channel(baked, 0, baked.places()[2 * k], baked.places()[2 * k + 1]), 1e-6);
        }
    }
}
