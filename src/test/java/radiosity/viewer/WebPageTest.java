package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.net.InetAddress;
import java.net.Socket;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.RadiosityRenderer;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.ToneMapping;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.viewer.web.WebPage;

/** The web page, asked by HTTP and seen in Chromium. */
@Tag("slow")
class WebPageTest {

    @TempDir
    static Path folder;

    private static WebPage page;

    @BeforeAll
    static void serve() throws Exception {
        page = new WebPage(Rendered.cornellBox(folder), ToneMapping.Operator.REINHARD, 0, 0);
    }

    @AfterAll
    static void close() {
        page.close();
    }

    private static HttpResponse<String> get(String path) throws Exception {
        return HttpClient.newHttpClient().send(HttpRequest.newBuilder(page.address().resolve(path)).build(),
                HttpResponse.BodyHandlers.ofString());
    }

    @Test
    void everythingThePageNames_isServed() throws Exception {
        for (String path : List.of("/", "/walk.js", "/keys.js", "/panel.js", "/lamps.js", "/obstacles.js",
                "/light.frag", "/settings.json", "/scene.glb",
                "/three/build/three.module.min.js", "/three/build/three.core.min.js",
                "/three/examples/jsm/loaders/GLTFLoader.js", "/three/examples/jsm/utils/BufferGeometryUtils.js")) {
            HttpResponse<String> answer = get(path);
            assertEquals(200, answer.statusCode(), path);
            assertTrue(answer.body().length() > 80, path);
        }
    }

    @Test
    void nothingElse_isServed() throws Exception {
        assertEquals(404, get("/box.png").statusCode());
        assertEquals(404, get("/..%2fbox.png").statusCode());
        assertEquals(404, get("/three/package.json").statusCode());
    }

    @Test
    void foreignFile_isRefusedAtOnce() throws Exception {
        Path poem = Files.writeString(folder.resolve("poem.scene"), "A poem of more than twenty bytes");
        assertThrows(SceneFormatException.class, () -> new WebPage(poem, ToneMapping.Operator.REINHARD, 0, 0));
    }

    @Test
    void browser_showsTheSamePictureAndWalksByKey() throws Exception {
        try (Browser browser = new Browser(Files.createDirectory(folder.resolve("profile")), Rendered.SIZE)) {
            browser.open(page.address());
            assertFalse(browser.value("document.getElementById('hint').hidden").asBoolean(), "the keys are hinted at");
            browser.tap("Space", " ");
            BufferedImage start = browser.screenshot();
            double difference = Rendered.difference(start, Rendered.picture(folder.resolve("box.png")));
            assertTrue(difference <= 3, "mean difference " + difference + " of 255");
            browser.holdUntil("ArrowUp", "ArrowUp", "walk.eye.z < 700");
            assertTrue(Rendered.difference(start, browser.screenshot()) > 3, "walked ahead");
            browser.tap("Home", "Home");
            assertEquals(0, Rendered.difference(start, browser.screenshot()), 0.01);
            browser.tap("KeyC", "c");
            assertEquals(4, browser.value("document.querySelectorAll('#scale li').length").asInt());
            assertTrue(browser.value("document.getElementById('scale').textContent").asText().startsWith("W/m"));
            browser.tap("KeyC", "c");
            assertTrue(browser.value("document.getElementById('scale').hidden").asBoolean(), "no scale without colours");
            browser.tap("KeyT", "t");
            assertTrue(browser.value("document.getElementById('text').textContent").asText().endsWith("filmic"));
            browser.tap("Minus", "-");
            browser.tap("Minus", "-");
            browser.tap("Minus", "-");
            assertTrue(Rendered.brightness(browser.screenshot()) < 0.9 * Rendered.brightness(start), "darker");
            assertEquals(List.of(), browser.errors);
        }
    }

    /** An arc of facets that OBJ says to be smooth, below a lamp; both are lamps. */
    private static Path arc() throws Exception {
        StringBuilder obj = new StringBuilder("mtllib arc.mtl\n");
        for (int i = 0; i <= 8; i++) {
            double turn = Math.PI * i / 8;
            for (int z = 0; z < 2; z++) {
                obj.append("v " + Math.cos(turn) + " " + Math.sin(turn) + " " + z + "\n");
            }
        }
        obj.append("v 2 3 0\nv 2 3 1\nv 3 2 1\nv 3 2 0\nusemtl lamp\nf 22 21 20 19\nusemtl arc\ns 1\n");
        for (int i = 0; i < 8; i++) {
            obj.append("f " + (2 * i + 3) + " " + (2 * i + 4) + " " + (2 * i + 2) + " " + (2 * i + 1) + "\n");
        }
        Files.writeString(folder.resolve("arc.mtl"), "newmtl lamp\nKe 9 8 7\nnewmtl arc\nKd .5 .6 .7\nKe .1 .1 .1\n");
        Path scene = folder.resolve("arc.scene");
        assertEquals(0, RadiosityRenderer.run("-q", "--layers", "--accuracy", "20%",
                Files.writeString(folder.resolve("arc.obj"), obj).toString(), scene.toString()));
        return scene;
    }

    private static void assertShown(Browser browser, Mesh mesh) throws Exception {
        JsonNode shown = browser.value("JSON.stringify(Array.from(walk.meshes.find(mesh => mesh.userData.light.surface"
                + " === 'arc').geometry.attributes.shown.array))");
        float[] numbers = new ObjectMapper().readValue(shown.asText(), float[].class);
        assertArrayEquals(mesh.shown(), numbers, 1e-5f);
        double most = 0;
        for (int i = 0; i < numbers.length; i++) {
            most = Math.max(most, Math.abs(numbers[i] - mesh.radiosity()[i]));
        }
        assertTrue(most > 1e-3, "smoothed by " + most);
    }

    @Test
    void browser_showsSmoothSurfacesAsTheWindowDoes() throws Exception {
        Path file = arc();
        LitScene scene = LitScene.read(file);
        int arc = scene.meshes().get(0).surface().name().equals("arc") ? 0 : 1;
        try (WebPage smooth = new WebPage(file, ToneMapping.Operator.REINHARD, 0, 0);
                Browser browser = new Browser(Files.createDirectory(folder.resolve("smooth")), Rendered.SIZE)) {
            browser.open(smooth.address());
            assertShown(browser, scene.meshes().get(arc));
            browser.set("lamp0", "50");
            assertShown(browser, scene.mixed(List.of(Rgb.grey(.5), Rgb.grey(1))).meshes().get(arc));
            assertEquals(List.of(), browser.errors);
        }
    }

    private static double[] probe(Browser browser, String name) throws Exception {
        return probe(browser, Rendered.SIZE / 10, Rendered.SIZE / 2, name);
    }

    private static double[] probe(Browser browser, int x, int y, String name) throws Exception {
        browser.click(x, y);
        return DrivenWindow.numbers(browser.value("document.getElementById('text').textContent").asText()
                .replace("\n", "; "),
                name);
    }

    @Test
    void browser_mixesLampsProbesAndShowsTextures() throws Exception {
        Path lamps = TwoLamps.write(Files.createDirectory(folder.resolve("lamps")));
        try (WebPage two = new WebPage(lamps, ToneMapping.Operator.REINHARD, 0, 0);
                Browser browser = new Browser(Files.createDirectory(folder.resolve("second")), Rendered.SIZE)) {
            browser.open(two.address());
            browser.tap("Space", " ");
            BufferedImage start = browser.screenshot();
            double[] both = probe(browser, "radiosity");
            assertFalse(browser.value("document.getElementById('mark').hidden").asBoolean(), "a mark at the probe");
            assertEquals(Rendered.SIZE / 10, browser.value("parseFloat(document.getElementById('mark').style.left)")
                    .asDouble(), 1);
            double[] lamp = probe(browser, Rendered.SIZE / 2, Rendered.SIZE * 57 / 400, "exitance");
            assertTrue(lamp[0] > 0, "the lamp emits");
            double[] reflectance = probe(browser, "reflectance");
            double[] irradiance = probe(browser, "irradiance");
            browser.set("lamp1", "0");
            double[] ceiling = probe(browser, "radiosity");
            browser.value("document.getElementById('solo1').click()");
            double[] other = probe(browser, "radiosity");
            browser.value("document.getElementById('off1').click()");
            assertEquals(0, probe(browser, "irradiance")[0], "both are out");
            browser.set("lamp0", "100");
            double[] again = probe(browser, "radiosity");
            browser.set("lamp1", "100");
            browser.set("lamp0", "30");
            double[] mixed = probe(browser, "radiosity");
            for (int c = 0; c < 3; c++) {
                assertEquals(both[c], reflectance[c] * irradiance[c], 2e-3 * both[c]);
                assertEquals(both[c], ceiling[c] + other[c], 2e-3 * both[c]);
                assertEquals(ceiling[c], again[c], 1e-9);
                assertEquals(both[c] - 0.7 * ceiling[c], mixed[c], 2e-3 * both[c]);
            }
            double[] dimmed = probe(browser, Rendered.SIZE / 2, Rendered.SIZE * 57 / 400, "exitance");
            assertEquals(0.3 * lamp[0], dimmed[0], 2e-3 * lamp[0]);
            browser.set("colour0", "#ff0000");
            assertTrue(probe(browser, "radiosity")[0] / mixed[0] > 0.999, "as much red as before");
            saveAndLoadMix(browser);
            browser.value("document.getElementById('asRendered').click()");
            browser.tap("Space", " ");
            assertEquals(0, Rendered.difference(start, browser.screenshot()), 0.01, "as rendered");
            browser.tap("KeyU", "u");
            browser.tap("Space", " ");
            double textures = Rendered.difference(start, browser.screenshot());
            assertTrue(textures > 0 && textures <= 2, "textures differ by " + textures + " of 255");
            assertEquals(List.of(), browser.errors);
        }
    }

    /** The mix that the page saves comes back from a file; what is no mix is refused in a line. */
    private static void saveAndLoadMix(Browser browser) throws Exception {
        double[] mixed = probe(browser, "radiosity");
        browser.value("URL.createObjectURL = blob => { blob.text().then(text => { window.saved = text; });"
                + " return 'data:,'; }; document.getElementById('saveMix').click()");
        assertTrue(browser.becomes("window.saved?.startsWith('0.3 0 0 ')"), "the mix is saved");
        browser.value("document.getElementById('asRendered').click()");
        choose(browser, "window.saved");
        assertTrue(browser.becomes("document.getElementById('lamp0').value === '30'"), "the mix is loaded");
        assertArrayEquals(mixed, probe(browser, "radiosity"));
        choose(browser, "'bright blue'");
        assertTrue(browser.becomes("document.getElementById('text').textContent"
                + " === \"a.mix, line 1: expected three factors and a lamp's name, got bright blue\""));
    }

    private static void choose(Browser browser, String text) throws Exception {
        browser.value("{const chosen = new DataTransfer(), part = document.querySelector('#panel input[type=file]');"
                + " chosen.items.add(new File([" + text + "], 'a.mix')); part.files = chosen.files;"
                + " part.dispatchEvent(new Event('change'));}");
    }

    /** Radiosity in lm/m2, irradiance in lx; luminance is radiosity by pi; the scale ends at the luminance that is red. */
    @Test
    void browser_speaksOfLuxAndCandela_wherePhotometric() throws Exception {
        Path lux = Rendered.cornellBox(Files.createDirectory(folder.resolve("lux")), "--unit", "mm", "--photometric");
        try (WebPage photometric = new WebPage(lux, ToneMapping.Operator.REINHARD, 0, 0);
                Browser browser = new Browser(Files.createDirectory(folder.resolve("fourth")), Rendered.SIZE)) {
            browser.open(photometric.address());
            double[] radiosity = probe(browser, "radiosity");
            double[] irradiance = probe(browser, "irradiance");
            String text = browser.value("document.getElementById('text').textContent").asText();
            assertTrue(text.matches("(?s).*\nradiosity [^\n]* lm/m²\nirradiance [^\n]* lx\n.*"), text);
            Matcher y = Pattern.compile("luminance Y +(\\S+) cd/m², illuminance (\\S+) lx").matcher(text);
            assertTrue(y.find(), text);
            assertEquals(weighted(radiosity) / Math.PI, Double.parseDouble(y.group(1)), 2e-3 * weighted(radiosity));
            assertEquals(weighted(irradiance), Double.parseDouble(y.group(2)), 2e-3 * weighted(irradiance));
            browser.tap("KeyC", "c");
            assertTrue(browser.value("document.getElementById('scale').textContent").asText().startsWith("cd/m²"));
            assertTrue(text.matches("(?s).*\nexitance [^\n]* lm/m²\n.*"), text);
            double red = browser.value("4 / walk.light.exposure.value").asDouble() / Math.PI;
            assertEquals(red, browser.value("document.querySelector('#scale li').textContent").asDouble(), 1e-2 * red);
            browser.tap("KeyT", "t");
            text = browser.value("document.getElementById('text').textContent").asText();
            assertTrue(text.matches("exposure \\S+ per lm/m² .*"), text);
            assertEquals(List.of(), browser.errors);
        }
    }

    private static double weighted(double[] rgb) {
        return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    }

    @Test
    void settings_nameTheUnits() throws Exception {
        JsonNode units = new ObjectMapper().readTree(get("/settings.json").body()).get("units");
        assertEquals("W/m²", units.get("exitance").textValue());
        assertEquals("W/m² (Y)", units.get("scale").textValue());
        assertEquals(1, units.get("luminancePerRadiosity").doubleValue());
    }

    @Test
    void browser_stopsAtWallsUnlessTold() throws Exception {
        try (Browser browser = new Browser(Files.createDirectory(folder.resolve("third")), Rendered.SIZE)) {
            browser.open(page.address());
            String far = "for (let i = 0; i < 200; i++) walk.step(10, 0, 0); walk.eye.z";
            double stopped = browser.value(far).asDouble();
            assertTrue(stopped > -559 && stopped < -500, "before the back wall: " + stopped);
            browser.tap("Home", "Home");
            browser.tap("KeyK", "k");
            assertTrue(browser.value(far).asDouble() < -1000, "through the wall");
            browser.tap("KeyP", "p");
            assertTrue(browser.value("!document.getElementById('panel').hidden").asBoolean(), "the panel is shown");
            assertEquals(List.of(), browser.errors);
        }
    }

    @Test
    void strangeHostName_getsNothing() throws Exception {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(),
                page.address().getPort())) {
            socket.getOutputStream().write("GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n"
                    .getBytes(StandardCharsets.US_ASCII));
            assertTrue(new String(socket.getInputStream().readAllBytes(),
                    StandardCharsets.US_ASCII).startsWith("HTTP/1.1 403"));
        }
    }
}
