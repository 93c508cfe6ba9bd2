package radiosity.output.gltf;

import java.io.IOException;
import java.lang.reflect.Array;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import radiosity.gltf.JsonCursor;
import radiosity.scene.Camera;
import radiosity.scene.Lamp;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;

/** Describes a scene file in lines of text. Only the JSON of the file is read. */
public final class SceneInfo {

    /** Keys of extras.radiosity that {@link #rest} leaves out, because they have lines of their own. */
    private static final Set<String> SHOWN = Set.of("formatVersion", "program", "shots", "rounds", "unshotFlux",
            "ledger", "state", "channels", "lamps", "certificate", "units");

    /** Figures of a certificate that are parts of a mean: they are shown in per cent. */
    private static final Set<String> RELATIVE = Set.of("expected", "sampling", "meshing", "bias", "uncertainty",
            "reciprocity");

    /** Labels of a certificate's figures, in the order of the lines. */
    private static final Map<String, String> NAMES = new LinkedHashMap<>();

    private static final int MOST_NAMES = 20;
    /** Numbers whose absolute values are outside these limits are written with an exponent. */
    private static final double LEAST_PLAIN = 1e-4;
    private static final double MOST_PLAIN = 1e7;

    static {
        NAMES.put("expected", "error");
        NAMES.put("sampling", "error of rays");
        NAMES.put("meshing", "error of mesh");
        NAMES.put("bias", "bias of rays");
        NAMES.put("uncertainty", "uncertainty of the error");
        NAMES.put("points", "at points");
        NAMES.put("missingFlux", "upper bound on missing flux");
        NAMES.put("factors", "mean form-factor sum");
        NAMES.put("mostFactors", "largest form-factor sum");
        NAMES.put("reciprocity", "reciprocity error");
    }

    private final SceneFile file;
    private final Units units;
    private final JsonCursor root;
    private final List<String> lines = new ArrayList<>();

    private SceneInfo(SceneFile file) throws IOException {
        this.file = file;
        units = file.units();
        root = file.root();
    }

    /** Returns the lines that {@code --info} prints. */
    public static List<String> lines(Path path) throws IOException {
        try (SceneFile file = SceneFile.open(path)) {
            SceneInfo info = new SceneInfo(file);
            info.line("file", path + String.format(Locale.ROOT, ", %,d bytes", Files.size(path)));
            info.program();
            info.geometry();
            info.lamps();
            info.ledger();
            info.certificate();
            info.camera();
            info.rest();
            return info.lines;
        }
    }

    private void line(String name, String value) {
        lines.add(String.format(Locale.ROOT, "%-27s %s", name, SceneFormatException.escape(value)));
    }

    private void program() {
        Map<String, Object> extras = file.extras();
        line("format", String.valueOf(extras.get("formatVersion")));
        line("program", String.valueOf(extras.get("program")));
        line("shots", value(extras.get("shots")) + " in " + value(extras.get("rounds")) + " rounds");
        line("units", units.toString());
        line("state", extras.containsKey("state") ? "kept, the render can go on" : "none, the render cannot go on");
    }

    private void geometry() throws IOException {
        Range box = new Range();
        Range radiosity = new Range();
        Set<String> surfaces = new LinkedHashSet<>();
        long elements = 0;
        long vertices = 0;
        for (JsonCursor mesh : root.list("meshes")) {
            JsonCursor primitive = mesh.at("primitives").at(0);
            if (primitive.at("attributes").optional("_RADIOSITY").isEmpty()) {
                continue;
            }
            JsonCursor material = root.at("materials").at(primitive.at("material").integer());
            surfaces.add(material.at("extras").at("surface").text());
            elements += accessor(primitive.at("indices")).at("count").integer() / 3;
            JsonCursor position = accessor(primitive.at("attributes").at("POSITION"));
            vertices += position.at("count").integer();
            box.include(position);
            radiosity.include(accessor(primitive.at("attributes").at("_RADIOSITY")));
        }
        List<SceneNode> objects = file.objects();
        line("objects", objects.isEmpty() ? "none named" : objects.size() + ": "
                + names(objects.stream().map(SceneNode::name)));
        line("surfaces", surfaces.size() + ": " + names(surfaces.stream()));
        line("triangles", elements + ": mesh elements, and what closes the cracks between them");
        line("vertices", String.valueOf(vertices));
        if (elements > 0) {
            line("box", text(vec(box.low).plus(file.origin())) + " to " + text(vec(box.high).plus(file.origin())));
            line("radiosity", text(vec(radiosity.low)) + " to " + text(vec(radiosity.high)) + " " + units.exitance());
        }
    }

    private void lamps() throws IOException {
        List<Lamp> lamps = file.lamps();
        line("lamps", lamps.isEmpty() ? "not kept apart" : lamps.size() + " kept apart: "
                + names(lamps.stream().map(Lamp::name)));
    }

    private static String names(Stream<String> names) {
        List<String> all = names.toList();
        return String.join(", ", all.subList(0, Math.min(MOST_NAMES, all.size())))
                + (all.size() > MOST_NAMES ? ", ..." : "");
    }

    private static Vec3 vec(double[] v) {
        return new Vec3(v[0], v[1], v[2]);
    }

    private JsonCursor accessor(JsonCursor index) throws IOException {
        return root.at("accessors").at(index.integer());
    }

    /** Minimum and maximum of three components over several accessors. */
    private static final class Range {

        final double[] low = new double[3];
        final double[] high = new double[3];
        private boolean empty = true;

        void include(JsonCursor accessor) throws IOException {
            double[] min = accessor.at("min").numbers(3);
            double[] max = accessor.at("max").numbers(3);
            for (int a = 0; a < 3; a++) {
                low[a] = empty ? min[a] : Math.min(low[a], min[a]);
                high[a] = empty ? max[a] : Math.max(high[a], max[a]);
            }
            empty = false;
        }
    }

    private void ledger() throws IOException {
        EnergyLedger ledger = file.ledger();
        line("emitted", flux(ledger.emitted()));
        line("shot", flux(ledger.shot()) + ", reflected light among it");
        line("received", flux(ledger.received()));
        line("absorbed", flux(ledger.absorbed()));
        line("not yet distributed", flux(ledger.unshot()) + " net, what was shot too much subtracted; "
                + like(file.unshotFlux(), ledger) + " absolute");
        double[] deficit = new double[ledger.shot().length];
        Arrays.setAll(deficit, ledger::deficit);
        if (ledger.knowsEscaped()) {
            line("escaped", flux(ledger.escaped()) + ", found by rays");
            Arrays.setAll(deficit, c -> ledger.deficit(c) - ledger.escaped()[c]);
        }
        line(ledger.knowsEscaped() ? "lost" : "escaped or lost", flux(deficit));
    }

    /** Flux in the unit of flux, and by channels where there are three. */
    private String flux(double... flux) {
        double[] channels = Arrays.stream(flux).map(of -> of * units.fluxScale()).toArray();
        return number(units.flux(flux)) + " " + units.flux()
                + (flux.length == 3 ? " (R, G, B: " + value(channels) + ")" : "");
    }

    /** A sum over all channels in the unit of flux, where its colour is that of what is emitted. */
    private String like(double sum, EnergyLedger ledger) {
        return number(units.fluxLike(sum, ledger.emitted())) + " " + units.flux();
    }

    /** Adds the lines of the certificate's figures for the whole scene; figures of single surfaces are left out. */
    private void certificate() throws IOException {
        EnergyLedger ledger = file.ledger();
        if (file.extras().get("certificate") instanceof Map<?, ?> certificate) {
            Map<String, Object> whole = new TreeMap<>();
            certificate.forEach((key, value) -> whole.put(String.valueOf(key), value));
            whole.remove("surfaces");
            NAMES.forEach((key, name) -> {
                Object value = whole.remove(key);
                if (value instanceof Number flux && key.equals("missingFlux")) {
                    line(name, like(flux.doubleValue(), ledger));
                } else if (value instanceof Number part && RELATIVE.contains(key)) {
                    line(name, number(100 * part.doubleValue()) + " %");
                } else if (value != null) {
                    line(name, value(value));
                }
            });
            if (!whole.isEmpty()) {
                line("certificate", value(whole));
            }
        }
    }

    private void camera() throws IOException {
        if (file.camera().isEmpty()) {
            line("camera", "none");
            return;
        }
        Camera camera = file.camera().get();
        line("camera", "at " + text(camera.position()) + " towards " + text(camera.forward()) + String.format(
                Locale.ROOT, ", %.1f degrees high, aspect %.3f", 2 * Math.toDegrees(camera.verticalHalfAngle()),
                camera.aspect()));
    }

    private static String text(Vec3 v) {
        return number((float) v.x()) + ", " + number((float) v.y()) + ", " + number((float) v.z());
    }

    private void rest() {
        new TreeMap<>(file.extras()).forEach((key, value) -> {
            if (key.equals("commandLine") && value instanceof Collection<?> words) {
                line("command line", words.stream().map(String::valueOf).collect(Collectors.joining(" ")));
            } else if (!SHOWN.contains(key)) {
                line(key, value(value));
            }
        });
    }

    /** A value of the extras as text: real numbers with five digits, lists and arrays by their members. */
    private static String value(Object value) {
        if (value instanceof Map<?, ?> map) {
            return map.entrySet().stream().map(entry -> entry.getKey() + "=" + value(entry.getValue()))
                    .collect(Collectors.joining(", "));
        }
        if (value instanceof Collection<?> list) {
            return list.stream().map(SceneInfo::value).collect(Collectors.joining(", "));
        }
        if (value != null && value.getClass().isArray()) {
            return IntStream.range(0, Array.getLength(value)).mapToObj(i -> value(Array.get(value, i)))
                    .collect(Collectors.joining(", "));
        }
        return value instanceof Double || value instanceof Float || value instanceof BigDecimal
                ? number(((Number) value).doubleValue()) : String.valueOf(value);
    }

    private static String number(double value) {
        if (!Double.isFinite(value) || value == 0) {
            return value == 0 ? "0" : String.valueOf(value);
        }
        BigDecimal rounded = new BigDecimal(value).round(new MathContext(5)).stripTrailingZeros();
        double size = Math.abs(value);
        return size >= LEAST_PLAIN && size < MOST_PLAIN ? rounded.toPlainString()
                : rounded.toString().replace("E+", "E");
    }
}
