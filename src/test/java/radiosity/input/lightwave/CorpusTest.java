package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.IntList;
import radiosity.input.file.WorkBudget;
import radiosity.input.lightwave.SceneAssembly.Reading;
import radiosity.input.lightwave.lwo.Layer;
import radiosity.input.lightwave.lwo.ObjectFile;
import radiosity.input.lightwave.lwo.ObjectModel;
import radiosity.input.lightwave.lwo.SurfaceValues;
import radiosity.input.lightwave.lws.SceneDescription;
import radiosity.input.lightwave.lws.SceneItem;
import radiosity.input.polygon.Triangulation;
import radiosity.scene.Affine;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;
import radiosity.testkit.NeedsReference;

/**
 * Real files against what an independent reader found in their bytes: expected.json, in left-handed coordinates, scenes
 * posed at the first key of every channel.
 */
@NeedsReference("lightwave/expected.json")
class CorpusTest {

    private static final double AREA = 1e-4;
    private static final double COLOUR = 1e-5;

    @TestFactory
    Stream<DynamicTest> objects_areReadAsExpected() throws IOException {
        return stream("objects").map(o -> dynamicTest(o.get("file").asText(), () -> assertObject(o)));
    }

    @TestFactory
    Stream<DynamicTest> scenes_areReadAsExpected() throws IOException {
        return stream("scenes").map(s -> dynamicTest(s.get("file").asText(), () -> assertScene(s)));
    }

    private static Stream<JsonNode> stream(String list) throws IOException {
        JsonNode all = new ObjectMapper().readTree(Shared.path("lightwave/expected.json").toFile()).get(list);
        return StreamSupport.stream(all.spliterator(), false);
    }

    private static Path file(JsonNode expected) {
        return Shared.path("lightwave/corpus/" + expected.get("file").asText());
    }

    private static void assertObject(JsonNode expected) throws IOException {
        byte[] bytes = Files.readAllBytes(file(expected));
        String name = expected.get("file").asText();
        ObjectModel object = ObjectFile.read(bytes, name, new Diagnostics(name, w -> { }, false));
        assertEquals(expected.get("format").asText(), object.format);
        assertEquals(expected.get("points").asInt(), object.layers.stream().mapToInt(Layer::pointCount).sum());
        assertLayers(expected.get("layers"), object);
        Map<String, Double> areas = areas(object);
        for (JsonNode surface : expected.get("surfaces")) {
            assertSurface(surface, object.surfaces.get(surface.get("name").asText()), areas);
        }
        if (!expected.get("bbox").isNull()) {
            assertBox(expected.get("bbox"), pointBox(object));
        }
    }

    private static void assertLayers(JsonNode expected, ObjectModel object) {
        assertEquals(expected.size(), object.layers.size());
        for (int i = 0; i < expected.size(); i++) {
            Layer layer = object.layers.get(i);
            assertEquals(expected.get(i).get("number").asInt(), layer.number);
            for (int k = 0; k < 3; k++) {
                assertEquals(expected.get(i).get("pivot").get(k).asDouble(), layer.pivot[k], 1e-5);
            }
        }
    }

    /** Areas of the polygons by surface; on the way each polygon's triangles must have the polygon's area vector. */
    private static Map<String, Double> areas(ObjectModel object) {
        Map<String, Double> areas = new HashMap<>();
        for (Layer layer : object.layers) {
            Diagnostics notes = new Diagnostics("layer", w -> { }, false);
            Triangulation triangulation = new Triangulation(layer.points, layer.polygons,
                    polygon -> "layer " + layer.number,
                    new WorkBudget(), notes);
            for (int polygon = 0; polygon < layer.polygons.size(); polygon++) {
                Vec3 expected = PolygonAreas.ofPolygon(layer, polygon);
                IntList triangles = new IntList();
                triangulation.cut(polygon, triangles);
                if (triangles.size() > 0) {
                    Vec3 got = PolygonAreas.ofTriangles(layer, triangles);
                    assertEquals(0, got.minus(expected).length(), 1e-6 * expected.length(), "polygon " + polygon);
                }
                areas.merge(object.tags.get(Math.max(0, layer.polygons.tag(polygon))), expected.length(), Double::sum);
            }
        }
        return areas;
    }

    private static void assertSurface(JsonNode expected, SurfaceValues surface, Map<String, Double> areas) {
        assertColour(expected.get("color"), surface.colour);
        assertEquals(expected.get("diffuse").asDouble(), surface.diffuse, COLOUR);
        assertEquals(expected.get("luminosity").asDouble(), surface.luminosity, COLOUR);
        assertEquals(expected.get("specular").asDouble(), surface.specular, COLOUR);
        assertEquals(expected.get("transparency").asDouble(), surface.transparency, COLOUR);
        assertEquals(expected.get("sides").asInt() == 3, surface.twoSided);
        assertColour(expected.get("reflectance"), surface.reflectance(false));
        assertColour(expected.get("emission"), surface.luminosityExitance(false));
        double area = expected.get("area").asDouble();
        assertEquals(area, areas.getOrDefault(surface.name, 0.0), AREA * area, surface.name);
    }

    private static void assertColour(JsonNode expected, Rgb got) {
        for (int c = 0; c < 3; c++) {
            assertEquals(expected.get(c).asDouble(), got.channel(c), COLOUR);
        }
    }

    /** The box of the points that polygons use. */
    private static double[] pointBox(ObjectModel object) {
        double[] box = emptyBox();
        for (Layer layer : object.layers) {
            for (int polygon = 0; polygon < layer.polygons.size(); polygon++) {
                int start = layer.polygons.start(polygon);
                int end = layer.polygons.end(polygon);
                for (int i = 3 * start; i < 3 * end && end - start > 2; i++) {
                    extend(box, i % 3, layer.points.get(3 * layer.polygons.point(i / 3) + i % 3));
                }
            }
        }
        return box;
    }

    private static double[] emptyBox() {
        double inf = Double.POSITIVE_INFINITY;
        return new double[] {inf, inf, inf, -inf, -inf, -inf};
    }

    private static void extend(double[] box, int k, double value) {
        box[k] = Math.min(box[k], value);
        box[k + 3] = Math.max(box[k + 3], value);
    }

    private static void assertBox(JsonNode expected, double[] box) {
        double size = 0;
        for (int k = 0; k < 3; k++) {
            size = Math.max(size, expected.get(k + 3).asDouble() - expected.get(k).asDouble());
        }
        for (int k = 0; k < 6; k++) {
            assertEquals(expected.get(k).asDouble(), box[k], 1e-5 * size, "box " + k);
        }
    }

    private static void assertScene(JsonNode expected) throws IOException {
        ReadOptions options = ReadOptions.defaults().withFrame(Double.NEGATIVE_INFINITY);
        Reading reading = SceneAssembly.read(file(expected), options, w -> { });
        Scene scene = reading.scene();
        assertEquals(expected.get("triangles").asInt(), scene.triangles());
        assertBox(expected.get("bbox"), leftHandedBox(scene));
        Map<String, Double> areas = new HashMap<>();
        double luminous = 0;
        for (int t = 0; t < scene.triangles(); t++) {
            areas.merge(scene.surface(t).name(), scene.area(t), Double::sum);
            luminous += scene.surface(t).emits() ? scene.area(t) : 0;
        }
        assertEquals(expected.get("luminous_area").asDouble(), luminous, AREA * luminous);
        assertEquals(expected.get("surfaces").size(), areas.size());
        for (JsonNode surface : expected.get("surfaces")) {
            double area = surface.get("area").asDouble();
            assertEquals(area, areas.get(surface.get("name").asText()), AREA * area);
        }
        assertItems(expected, reading);
    }

    private static double[] leftHandedBox(Scene scene) {
        double[] box = emptyBox();
        for (int t = 0; t < scene.triangles(); t++) {
            for (int k = 0; k < 3; k++) {
                extend(box, 0, scene.corner(t, k).x());
                extend(box, 1, scene.corner(t, k).y());
                extend(box, 2, -scene.corner(t, k).z());
            }
        }
        return box;
    }

    private static void assertItems(JsonNode expected, Reading reading) {
        SceneDescription scene = reading.description();
        assertEquals(expected.get("version").asInt(), scene.version);
        assertEquals(expected.get("first_frame").asDouble(), scene.firstFrame());
        assertEquals(expected.get("lights").asInt(), scene.items(SceneItem.Kind.LIGHT).size());
        assertEquals(expected.get("cameras").asInt(), scene.items(SceneItem.Kind.CAMERA).size());
        assertEquals(expected.get("items").size(), scene.items.size());
        for (JsonNode item : expected.get("items")) {
            SceneItem.Kind kind = SceneItem.Kind.valueOf(item.get("type").asText().toUpperCase(java.util.Locale.ROOT));
            Affine world = reading.placement().world(scene.items(kind).get(item.get("number").asInt()));
            for (int i = 0; i < 12; i++) {
                double value = item.get("world").get(i).asDouble();
                assertEquals(value, world.m()[i], 1e-5 * Math.max(1, Math.abs(value)), kind + " world " + i);
            }
        }
        assertTrue(expected.get("unresolved").asInt() == 0);
    }
}
