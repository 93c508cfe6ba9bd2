package radiosity.torture;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.IntStream;
import radiosity.cli.RadiosityRenderer;

/** RadiosityRenderer with a fault that a campaign must find; the property "planted" says which. */
public final class PlantedProgram {

    /** What is wrong with it. */
    enum Plant {
        /** Nothing. */
        NONE,
        /** It ends with a code that is not documented. */
        EXIT_CODE,
        /** One number of the scene file is none. */
        NAN,
        /** In distributed mode the light of a block of vertices is missing. */
        LOST_BLOCK,
        /** The scene file is not replaced at once. */
        TORN_FILE,
        /** On several threads it adds in the order in which they come. */
        ORDER_OF_ARRIVAL,
        /** On black surfaces, more light arrives than was sent. */
        GAINED_ENERGY,
        /** One radiosity is a little below 0. */
        NEGATIVE
    }

    private final List<String> arguments;
    private final Path output;

    private PlantedProgram(String[] arguments) {
        this.arguments = List.of(arguments);
        output = Path.of(arguments.length == 0 ? "" : arguments[arguments.length - 1]);
    }

    /** @param arguments of RadiosityRenderer */
    public static void main(String[] arguments) throws Exception {
        System.exit(new PlantedProgram(arguments).run(Plant.valueOf(System.getProperty("planted"))));
    }

    private int run(Plant plant) throws Exception {
        boolean renders = output.toString().endsWith(".scene") && arguments.contains("-t");
        if (plant == Plant.TORN_FILE && renders) {
            Files.write(output, new byte[] {'g', 'l', 'T', 'F', 2, 0, 0, 0});
        }
        int code = RadiosityRenderer.run(arguments.toArray(String[]::new));
        if (!renders || code != 0) {
            return code;
        }
        int threads = Integer.parseInt(arguments.get(arguments.indexOf("-t") + 1));
        switch (plant) {
            case EXIT_CODE -> {
                return 7;
            }
            case NAN -> damage((values, radiosity) -> values[values.length / 2] = Float.NaN);
            case LOST_BLOCK -> {
                if (arguments.contains("-h")) {
                    damage((values, radiosity) -> Arrays.fill(values, values.length / 4, values.length / 2, 0));
                }
            }
            case ORDER_OF_ARRIVAL -> {
                if (threads > 1) {
                    float more = sumAsItComes() - sumInOrder();
                    damage((values, radiosity) -> values[0] += Math.abs(values[0]) * more);
                }
            }
            case GAINED_ENERGY -> damage((values, radiosity) -> {
                for (int i = 0; i < values.length; i++) {
                    values[i] *= radiosity ? 1 : 1.1f;
                }
            });
            case NEGATIVE -> damage((values, radiosity) -> values[0] = radiosity ? -1e-3f : values[0]);
            default -> {
                // sound, or torn already
            }
        }
        return code;
    }

    private static float sumInOrder() {
        float sum = 0;
        for (int i = 0; i < 10_000; i++) {
            sum += 1f / (i + 1);
        }
        return sum;
    }

    private static float sumAsItComes() {
        AtomicReference<Float> sum = new AtomicReference<>(0f);
        IntStream.range(0, 10_000).parallel().forEach(i -> sum.accumulateAndGet(1f / (i + 1), Float::sum));
        return sum.get();
    }

    /** Changes numbers. */
    private interface Damage {
        void to(float[] values, boolean radiosity);
    }

    /** Changes the radiosity and the irradiance of all meshes. */
    private void damage(Damage damage) throws IOException {
        byte[] bytes = Files.readAllBytes(output);
        ByteBuffer file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        int jsonLength = file.getInt(12);
        JsonNode json = new ObjectMapper().readTree(Arrays.copyOfRange(bytes, 20, 20 + jsonLength));
        for (JsonNode mesh : json.get("meshes")) {
            for (String attribute : List.of("_IRRADIANCE", "_RADIOSITY")) {
                JsonNode number = mesh.at("/primitives/0/attributes").path(attribute);
                if (number.isMissingNode()) {
                    continue; // what does not radiate
                }
                JsonNode accessor = json.get("accessors").get(number.asInt());
                JsonNode view = json.get("bufferViews").get(accessor.get("bufferView").asInt());
                ByteBuffer at = file.duplicate().order(ByteOrder.LITTLE_ENDIAN)
                        .position(28 + jsonLength + view.path("byteOffset").asInt());
                float[] values = new float[3 * accessor.get("count").asInt()];
                at.slice().order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer().get(values);
                damage.to(values, attribute.equals("_RADIOSITY"));
                at.slice().order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer().put(values);
            }
        }
        Files.write(output, bytes);
    }
}
