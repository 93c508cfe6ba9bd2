package radiosity.viewer;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.File;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.imageio.ImageIO;

/** A headless Chromium with one page, steered by the DevTools protocol; tests are skipped where there is none. */
final class Browser implements AutoCloseable, WebSocket.Listener {

    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int SECONDS = 60;

    private final Process process;
    private final WebSocket socket;
    private final BlockingQueue<JsonNode> answers = new LinkedBlockingQueue<>();
    private final StringBuilder part = new StringBuilder();
    /** What the page has complained about. */
    final List<String> errors = new ArrayList<>();
    private int last;

    Browser(Path profile, int size) throws Exception {
        String chromium = Stream.of(System.getenv("PATH").split(File.pathSeparator))
                .flatMap(d -> Stream.of("chromium", "chromium-browser", "google-chrome").map(n -> Path.of(d, n)))
                .filter(Files::isExecutable).map(Path::toString).findFirst().orElse(null);
        assumeTrue(chromium != null, "no Chromium: the web page is not tested (apt-get install chromium)");
        process = new ProcessBuilder(chromium, "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader", "--hide-scrollbars", "--no-first-run", "--remote-debugging-port=0",
                "--user-data-dir=" + profile, "about:blank").redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
        HttpClient http = HttpClient.newHttpClient();
        socket = http.newWebSocketBuilder().buildAsync(page(http, profile), this).get(SECONDS, TimeUnit.SECONDS);
        call("Runtime.enable", Map.of());
        call("Log.enable", Map.of());
        call("Page.enable", Map.of());
        call("Emulation.setDeviceMetricsOverride", Map.of("width", size, "height", size, "deviceScaleFactor", 1,
                "mobile", false));
    }

    /** Chromium writes its port into a file of its profile. */
    private URI page(HttpClient http, Path profile) throws Exception {
        Path port = profile.resolve("DevToolsActivePort");
        for (int i = 0; i < 10 * SECONDS && !(Files.exists(port) && Files.readString(port).contains("\n")); i++) {
            assumeTrue(process.isAlive(), "Chromium does not start: the web page is not tested");
            Thread.sleep(100);
        }
        String list = http.send(HttpRequest.newBuilder(URI.create("http://127.0.0.1:"
                + Files.readAllLines(port).get(0) + "/json/list")).build(), HttpResponse.BodyHandlers.ofString())
                        .body();
        for (JsonNode target : JSON.readTree(list)) {
            if (target.get("type").asText().equals("page")) {
                return URI.create(target.get("webSocketDebuggerUrl").asText());
            }
        }
        throw new IllegalStateException("expected a page, got " + list);
    }

    @Override
    public CompletionStage<?> onText(WebSocket webSocket, CharSequence data, boolean isLast) {
        part.append(data);
        if (isLast) {
            receive(part.toString());
            part.setLength(0);
        }
        webSocket.request(1);
        return null;
    }

    private void receive(String text) {
        try {
            JsonNode message = JSON.readTree(text);
            String method = message.path("method").asText();
            boolean complaint = method.equals("Runtime.exceptionThrown")
                    || method.equals("Log.entryAdded") && message.at("/params/entry/level").asText().equals("error")
                    || method.equals("Runtime.consoleAPICalled") && message.at("/params/type").asText().equals("error");
            if (complaint) {
                errors.add(text);
            }
            if (message.has("id")) {
                answers.add(message);
            }
        } catch (JsonProcessingException e) {
            errors.add(e.toString());
        }
    }

    /** The browser's answer, which may be an error; null where none came in time. */
    private JsonNode ask(String method, Map<String, ?> parameters) throws Exception {
        socket.sendText(JSON.writeValueAsString(Map.of("id", ++last, "method", method, "params", parameters)), true);
        return answers.poll(SECONDS, TimeUnit.SECONDS);
    }

    JsonNode call(String method, Map<String, ?> parameters) throws Exception {
        JsonNode answer = ask(method, parameters);
        if (answer == null || answer.has("error")) {
            throw new IllegalStateException(method + ": expected an answer, got " + answer + " " + errors);
        }
        return answer.get("result");
    }

    /** The value of an expression on the page. */
    JsonNode value(String expression) throws Exception {
        return call("Runtime.evaluate", Map.of("expression", expression, "returnByValue", true)).at("/result/value");
    }

    /** Whether a condition on the page holds within some time. */
    boolean becomes(String condition) throws Exception {
        for (int i = 0; i < 10 * SECONDS; i++) {
            if (value(condition).asBoolean()) {
                return true;
            }
            Thread.sleep(100);
        }
        return false;
    }

    /** Opens a page and waits until it says that it is ready. */
    void open(URI page) throws Exception {
        call("Page.navigate", Map.of("url", page.toString()));
        for (int i = 0; i < 10 * SECONDS; i++) {
            if (!errors.isEmpty()) {
                throw new IllegalStateException(errors.toString());
            }
            if (isReady()) {
                return;
            }
            Thread.sleep(100);
        }
        throw new IllegalStateException(page + " is not ready after " + SECONDS + " s");
    }

    /** A question that is under way while the page before it goes is answered with an error: not ready. */
    private boolean isReady() throws Exception {
        JsonNode answer = ask("Runtime.evaluate",
                Map.of("expression", "document.body?.dataset.ready", "returnByValue", true));
        return answer != null && answer.at("/result/result/value").asText().equals("yes");
    }

    void tap(String code, String key) throws Exception {
        call("Input.dispatchKeyEvent", Map.of("type", "keyDown", "code", code, "key", key));
        call("Input.dispatchKeyEvent", Map.of("type", "keyUp", "code", code, "key", key));
    }

    /** Until an expression on the page holds. */
    void holdUntil(String code, String key, String condition) throws Exception {
        call("Input.dispatchKeyEvent", Map.of("type", "keyDown", "code", code, "key", key));
        for (int i = 0; i < 10 * SECONDS && !value(condition).asBoolean(); i++) {
            Thread.sleep(100);
        }
        call("Input.dispatchKeyEvent", Map.of("type", "keyUp", "code", code, "key", key));
    }

    /** A slider of the panel, or a colour. */
    void set(String id, String to) throws Exception {
        value("{const part = document.getElementById('" + id + "'); part.value = '" + to
                + "'; part.dispatchEvent(new Event('input'));}");
    }

    void click(int x, int y) throws Exception {
        for (String type : List.of("mousePressed", "mouseReleased")) {
            call("Input.dispatchMouseEvent", Map.of("type", type, "x", x, "y", y, "button", "left", "clickCount", 1));
        }
    }

    BufferedImage screenshot() throws Exception {
        String data = call("Page.captureScreenshot", Map.of("format", "png")).get("data").asText();
        return ImageIO.read(new ByteArrayInputStream(Base64.getDecoder().decode(data)));
    }

    @Override
    public void close() {
        socket.abort();
        List<ProcessHandle> helpers = process.descendants().toList();
        process.destroy();
        process.onExit().join();
        helpers.forEach(ProcessHandle::destroyForcibly);
        helpers.forEach(helper -> helper.onExit().join());
    }
}
