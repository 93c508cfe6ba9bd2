package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import radiosity.gltf.JsonCursor;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.Mesh;
import radiosity.output.mesh.SmoothShading;
import radiosity.output.mesh.TJunctions;
import radiosity.scene.Rgb;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/** Facets of a curved surface are shown smoothly; the light that was calculated stays. */
class SmoothShadingTest extends WrittenScene {

    private static final int FACETS = 12;
    private static final double FACET_ANGLE = 2 * Math.PI / FACETS;

    private static Surface surface(double smoothing) {
        return new Surface("drum", new Rgb(.1, .2, .3), new Rgb(.5, .4, .3), false).smoothed(smoothing);
    }

    /** Irradiance that is the same all over a facet, as on elements with one receiving point. */
    private static Rgb light(int facet) {
        return new Rgb(1 + facet % 3, 2 + facet % 4, 3 + facet % 5);
    }

    private static Vec3 rim(int i, double y) {
        double turn = i * FACET_ANGLE;
        return new Vec3(StrictMath.cos(turn), y, StrictMath.sin(turn));
    }

    /** A drum of radius 1 and height 2, open at both ends; every third facet is divided more finely. */
    private static Handmade drum(double smoothing) {
        Handmade made = new Handmade();
        int surface = made.surface(surface(smoothing));
        for (int f = 0; f < FACETS; f++) {
            int facet = f;
            Vec3 at = rim(f, 0);
            made.grid(surface, at, new Vec3(0, 2, 0), rim((f + 1) % FACETS, 0).minus(at), f % 3 == 0 ? 2 : 1, 1,
                    p -> light(facet));
        }
        return made;
    }

    /** Irradiances shown at each place, of all elements that meet there. */
    private static Map<Vec3, List<Rgb>> places(Solution shown) {
        Map<Vec3, List<Rgb>> places = new HashMap<>();
        for (int i = 0; i < shown.corners().length; i++) {
            places.computeIfAbsent(Elements.corner(shown, i / 3, i % 3), p -> new ArrayList<>())
                    .add(shown.irradianceAt(shown.corners()[i]));
        }
        return places;
    }

    private static double integral(Solution solution, int channel) {
        double sum = 0;
        for (int i = 0; i < solution.corners().length; i++) {
            sum += Elements.cross(solution, i / 3).length() / 6
                    * solution.irradianceAt(solution.corners()[i]).channel(channel);
        }
        return sum;
    }

    @Test
    void facetsWithinTheAngle_areShownAlikeWhereTheyMeet() {
        Solution closed = TJunctions.close(drum(Math.toRadians(45)).solution());
        Map<Vec3, List<Rgb>> places = places(SmoothShading.shown(closed));
        assertTrue(places.size() > 2 * FACETS, "hanging vertices are among them");
        places.forEach((place, lights) -> assertEquals(1, lights.stream().distinct().count(), place + " " + lights));
        for (int c = 0; c < 3; c++) {
            assertEquals(integral(closed, c), integral(SmoothShading.shown(closed), c), 1e-12 * integral(closed, c));
        }
    }

    @Test
    void meanIsWeightedByArea() {
        Handmade made = new Handmade();
        int surface = made.surface(surface(1));
        made.grid(surface, Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0), 1, 1, p -> Rgb.grey(1));
        made.grid(surface, new Vec3(1, 0, 0), new Vec3(3, 0, .1), new Vec3(0, 1, 0), 1, 1, p -> Rgb.grey(5));
        Solution shown = SmoothShading.shown(made.solution());
        // Of the first square two triangles have the corner (1, 1, 0), of the second one.
        double first = 2 * .5;
        double second = .5 * StrictMath.sqrt(9.01);
        assertEquals((first * 1 + second * 5) / (first + second),
                places(shown).get(new Vec3(1, 1, 0)).get(0).r(), 1e-12);
    }

    @Test
    void facetsBeyondTheAngle_areShownAsTheyAre() {
        Solution sharp = TJunctions.close(drum(FACET_ANGLE - .01).solution());
        assertSame(sharp, SmoothShading.shown(sharp));
        Solution flat = drum(0).solution();
        assertSame(flat, SmoothShading.shown(flat));
        Solution just = drum(FACET_ANGLE).solution();
        assertFalse(just == SmoothShading.shown(just), "an angle just as large is joined");
    }

    @Test
    void boxWithASmoothingAngleOf45Degrees_staysSharp() {
        Handmade made = new Handmade();
        int surface = made.surface(surface(Math.toRadians(45)));
        Vec3[] axes = {new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1)};
        for (int a = 0; a < 3; a++) {
            double side = a;
            made.grid(surface, Vec3.ZERO, axes[(a + 1) % 3], axes[a], 2, 2, p -> Rgb.grey(1 + side));
            made.grid(surface, axes[(a + 2) % 3], axes[a], axes[(a + 1) % 3], 2, 2, p -> Rgb.grey(4 + side));
        }
        Solution closed = TJunctions.close(made.solution());
        assertSame(closed, SmoothShading.shown(closed));
    }

    @Test
    void otherSurfaces_areNotJoined() {
        Handmade made = new Handmade();
        for (int f = 0; f < 2; f++) {
            int facet = f;
            int surface = made.surface(new Surface("s" + f, Rgb.BLACK, Rgb.grey(.5), false).smoothed(3));
            made.grid(surface, rim(f, 0), new Vec3(0, 2, 0), rim(f + 1, 0).minus(rim(f, 0)), 1, 1, p -> light(facet));
        }
        Solution closed = TJunctions.close(made.solution());
        assertSame(closed, SmoothShading.shown(closed));
    }

    private record Written(GlbReader glb, JsonCursor attributes) {

        byte[] bytes(String attribute) throws IOException {
            JsonCursor root = new JsonCursor(glb.name, glb.json);
            JsonCursor accessor = root.at("accessors").at(attributes.at(attribute).integer());
            ByteBuffer view = glb.view(accessor.at("bufferView").integer());
            byte[] bytes = new byte[view.remaining()];
            view.get(bytes);
            return bytes;
        }
    }

    private Written written(Solution solution) throws IOException {
        write(solution);
        GlbReader glb = new GlbReader(file);
        return new Written(glb, new JsonCursor(glb.name, glb.json).at("meshes").at(0).at("primitives").at(0)
                .at("attributes"));
    }

    @Test
    void measuredLight_isTheSameBytesWithAndWithoutSmoothing() throws IOException {
        Written flat = written(drum(0).solution());
        Map<String, byte[]> measured = new HashMap<>();
        for (String attribute : List.of("POSITION", "NORMAL", "_RADIOSITY", "_IRRADIANCE")) {
            measured.put(attribute, flat.bytes(attribute));
        }
        byte[] colours = flat.bytes("COLOR_0");
        assertFalse(flat.attributes.node().has("_SMOOTH"));
        flat.glb.close();
        Written smooth = written(drum(1).solution());
        for (Map.Entry<String, byte[]> entry : measured.entrySet()) {
            assertArrayEquals(entry.getValue(), smooth.bytes(entry.getKey()), entry.getKey());
        }
        byte[] shown = smooth.bytes("COLOR_0");
        assertEquals(colours.length, shown.length);
        assertFalse(Arrays.equals(colours, shown), "what is shown differs");
        assertColours(smooth);
        smooth.glb.close();
    }

    /** Vertices at one place have one colour; that of the mean irradiance as the pairs in the file give it. */
    private static void assertColours(Written smooth) throws IOException {
        ByteBuffer colours = ByteBuffer.wrap(smooth.bytes("COLOR_0")).order(ByteOrder.LITTLE_ENDIAN);
        ByteBuffer positions = ByteBuffer.wrap(smooth.bytes("POSITION")).order(ByteOrder.LITTLE_ENDIAN);
        ByteBuffer pairs = ByteBuffer.wrap(smooth.bytes("_SMOOTH")).order(ByteOrder.LITTLE_ENDIAN);
        ByteBuffer irradiance = ByteBuffer.wrap(smooth.bytes("_IRRADIANCE")).order(ByteOrder.LITTLE_ENDIAN);
        int vertices = positions.remaining() / 12;
        double[] means = new double[vertices];
        for (int v = 0; v < vertices; v++) {
            means[(int) pairs.getFloat(8 * v)] += (double) pairs.getFloat(8 * v + 4) * irradiance.getFloat(12 * v);
        }
        Map<List<Float>, Long> colourAt = new HashMap<>();
        for (int v = 0; v < vertices; v++) {
            List<Float> place = List.of(positions.getFloat(12 * v), positions.getFloat(12 * v + 4),
                    positions.getFloat(12 * v + 8));
            long colour = colours.getLong(8 * v);
            assertEquals(colourAt.computeIfAbsent(place, p -> colour), colour, place.toString());
            assertTrue(means[(int) pairs.getFloat(8 * v)] >= 1 && means[(int) pairs.getFloat(8 * v)] <= 3);
        }
    }

    @Test
    void fileReadAgain_showsWhatPicturesOfTheSolutionShow() throws IOException {
        Solution solution = drum(1).solution();
        write(solution);
        Map<Vec3, List<Rgb>> places = places(SmoothShading.shown(TJunctions.close(solution)));
        Mesh mesh = LitScene.read(file).meshes().get(0);
        assertEquals(1, mesh.surface().smoothing());
        for (int v = 0; v < mesh.vertices(); v++) {
            float[] x = mesh.positions();
            int at = 3 * v;
            Rgb shown = places.entrySet().stream().min(Comparator.comparingDouble(
                    place -> distance(place.getKey(), x, at))).orElseThrow().getValue().get(0);
            for (int c = 0; c < 3; c++) {
                assertEquals(mesh.surface().exitance().channel(c)
                        + mesh.surface().reflectance().channel(c) * shown.channel(c), mesh.shown()[3 * v + c], 1e-6);
            }
        }
        Solution again = LitScene.read(file).solution();
        places(SmoothShading.shown(again)).values().forEach(lights -> assertEquals(1, lights.stream().distinct()
                .count()));
    }

    private static double distance(Vec3 place, float[] x, int i) {
        return place.minus(new Vec3(x[i], x[i + 1], x[i + 2])).length();
    }
}
