package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.ToneMapping;
import radiosity.scene.SceneFormatException;

/** The web page, asked by HTTP and seen in Chromium. */
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
        for (String path : List.of("/", "/walk.js", "/light.frag", "/settings.json", "/scene.glb",
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
            BufferedImage start = browser.screenshot();
            double difference = Rendered.difference(start, Rendered.picture(folder.resolve("box.png")));
            assertTrue(difference <= 3, "mean difference " + difference + " of 255");
            browser.hold("ArrowUp", "ArrowUp", 400);
            assertTrue(Rendered.difference(start, browser.screenshot()) > 3, "walked ahead");
            browser.hold("Home", "Home", 50);
            assertEquals(0, Rendered.difference(start, browser.screenshot()), 0.01);
            browser.hold("KeyT", "t", 50);
            assertTrue(browser.value("document.getElementById('text').textContent").asText().endsWith("filmic"));
            browser.hold("Minus", "-", 50);
            browser.hold("Minus", "-", 50);
            browser.hold("Minus", "-", 50);
            assertTrue(Rendered.brightness(browser.screenshot()) < 0.9 * Rendered.brightness(start), "darker");
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
