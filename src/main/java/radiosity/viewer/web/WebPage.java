package radiosity.viewer.web;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Camera;
import radiosity.scene.Units;
import radiosity.scene.Vec3;

/** Serves a page on which the user walks through a scene file in a browser on this machine; needs no display itself. */
public final class WebPage implements Closeable {

    /** Path of three.js in the WebJar; the version is that of the project's pom.xml. */
    private static final String THREE = "/META-INF/resources/webjars/three/0.181.1/";
    private static final String JAVASCRIPT = "text/javascript; charset=utf-8";
    /** Files served besides the scene and its settings: path in the address, and resource. */
    private static final Map<String, String> RESOURCES = Map.ofEntries(
            Map.entry("/", "walk.html"),
            Map.entry("/walk.js", "walk.js"),
            Map.entry("/keys.js", "keys.js"),
            Map.entry("/panel.js", "panel.js"),
            Map.entry("/lamps.js", "lamps.js"),
            Map.entry("/obstacles.js", "obstacles.js"),
            Map.entry("/light.frag", "/radiosity/viewer/light.frag"),
            three("build/three.module.min.js"),
            three("build/three.core.min.js"),
            three("examples/jsm/loaders/GLTFLoader.js"),
            three("examples/jsm/utils/BufferGeometryUtils.js"));

    private final Path file;
    private final ToneMapping.Operator curve;
    private final double stops;
    private final HttpServer server;
    private final ExecutorService threads = Executors.newCachedThreadPool();

    /**
     * Starts the server; each visit reads the file again.
     *
     * @param file  a scene file
     * @param curve curve of the automatic exposure
     * @param stops brightness relative to the automatic exposure, EV
     * @param port  port on the loopback address; 0 for any free port
     * @throws IOException where the file is not a scene file, or the port is taken
     */
    public WebPage(Path file, ToneMapping.Operator curve, double stops, int port) throws IOException {
        this.file = file;
        this.curve = curve;
        this.stops = stops;
        settings();
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 0);
        server.createContext("/", this::answer);
        server.setExecutor(threads);
        server.start();
    }

    private static Map.Entry<String, String> three(String name) {
        return Map.entry("/three/" + name, THREE + name);
    }

    /** The address to open in a browser. */
    public URI address() {
        return URI.create("http://localhost:" + server.getAddress().getPort() + "/");
    }

    private void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            String path = exchange.getRequestURI().getPath();
            if (!isLocal(exchange) || !exchange.getRequestMethod().equals("GET")) {
                exchange.sendResponseHeaders(403, -1);
            } else if (path.equals("/scene.glb")) {
                sendScene(exchange);
            } else if (path.equals("/settings.json")) {
                send(exchange, "application/json", settings().getBytes(StandardCharsets.UTF_8));
            } else if (RESOURCES.containsKey(path)) {
                try (InputStream in = WebPage.class.getResourceAsStream(RESOURCES.get(path))) {
                    send(exchange, path.equals("/") ? "text/html; charset=utf-8" : JAVASCRIPT, in.readAllBytes());
                }
            } else {
                exchange.sendResponseHeaders(404, -1);
            }
        }
    }

    /** Whether a request names this machine: a page under another name that resolves to this machine gets nothing. */
    private static boolean isLocal(HttpExchange exchange) {
        String host = exchange.getRequestHeaders().getFirst("Host");
        return host != null && host.matches("(localhost|127\\.0\\.0\\.1|\\[::1])(:\\d+)?");
    }

    private void sendScene(HttpExchange exchange) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            exchange.getResponseHeaders().set("Content-Type", "model/gltf-binary");
            exchange.getResponseHeaders().set("Cache-Control", "no-store");
            exchange.sendResponseHeaders(200, 0);
            try (OutputStream out = exchange.getResponseBody()) {
                in.transferTo(out);
            }
        }
    }

    private static void send(HttpExchange exchange, String type, byte[] bytes) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", type);
        exchange.getResponseHeaders().set("Cache-Control", "no-store");
        exchange.sendResponseHeaders(200, bytes.length);
        exchange.getResponseBody().write(bytes);
    }

    /** Returns the visitor's first view, exposure and lamps, as JSON. */
    private String settings() throws IOException {
        LitScene scene = LitScene.read(file);
        Camera camera = scene.camera();
        ToneMapping toneMapping = ToneMapping.automatic(curve, scene.meshes(), Optional.of(camera), stops);
        Map<String, Object> settings = new TreeMap<>();
        settings.put("name", file.getFileName().toString());
        settings.put("exposure", toneMapping.exposure());
        settings.put("curve", curve.ordinal());
        settings.put("verticalHalfAngle", camera.verticalHalfAngle());
        settings.put("eye", numbers(camera.position()));
        settings.put("forward", numbers(camera.forward()));
        settings.put("lamps", scene.lamps());
        settings.put("units", words(scene.units()));
        scene.textures().ifPresent(textures -> settings.put("textures", Map.of("exposure",
                textures.toneMapping().exposure(), "curve", textures.toneMapping().operator().ordinal())));
        return new ObjectMapper().writeValueAsString(settings);
    }

    /** The names of the units of light, and the factor from radiosity to luminance, for the page's texts. */
    private static Map<String, Object> words(Units units) {
        return Map.of("exitance", Units.raised(units.exitance()), "irradiance", Units.raised(units.irradiance()),
                "irradianceWord", units.irradianceWord(), "luminance", Units.raised(units.luminance()), "scale",
                Units.raised(units.luminanceScale()), "luminancePerRadiosity", units.luminancePerRadiosity());
    }

    private static List<Double> numbers(Vec3 v) {
        return List.of(v.x(), v.y(), v.z());
    }

    @Override
    public void close() {
        server.stop(0);
        threads.shutdownNow();
    }
}
