package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.output.image.DefaultCamera;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/** The scene file says the units of its numbers. */
class SceneFileUnitsTest extends WrittenScene {

    private void write(Units units) throws IOException {
        Solution room = Handmade.litRoom(Vec3.ZERO).solution();
        write(new Solution(room.scene().with(units), room.channels(), room.positions(), room.irradiance(),
                room.corners(), room.faceOf(), 7, 5, .25, room.ledger(), SavedState.NONE));
    }

    /** Changes extras.radiosity of the file; only files without a state may become shorter. */
    private void change(Consumer<ObjectNode> change) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        int length = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt(12);
        ObjectMapper mapper = new ObjectMapper();
        ObjectNode root = (ObjectNode) mapper.readTree(bytes, 20, length);
        change.accept((ObjectNode) root.at("/asset/extras/radiosity"));
        byte[] json = mapper.writeValueAsString(root).getBytes(StandardCharsets.UTF_8);
        byte[] padded = Arrays.copyOf(json, (json.length + 3) / 4 * 4);
        Arrays.fill(padded, json.length, padded.length, (byte) ' ');
        ByteBuffer out = ByteBuffer.allocate(bytes.length - length + padded.length).order(ByteOrder.LITTLE_ENDIAN);
        out.put(bytes, 0, 8).putInt(out.capacity()).putInt(padded.length).put(bytes, 16, 4).put(padded)
                .put(bytes, 20 + length, bytes.length - 20 - length);
        Files.write(file, out.array());
    }

    private Units units() throws IOException {
        try (SceneFile scene = SceneFile.open(file)) {
            assertEquals(scene.units(), scene.solution().scene().units(), "of the solution");
            assertEquals(scene.units(), LitScene.read(file).units(), "of what is shown");
            assertEquals(scene.units(), LitScene.read(file).solution().scene().units(), "of pictures");
            return scene.units();
        }
    }

    @ParameterizedTest
    @CsvSource({"NaN, false", "NaN, true", "0.001, false", "0.3048, true"})
    void units_comeBack(double metres, boolean photometric) throws IOException {
        Units units = new Units(metres, photometric);
        write(units);
        assertEquals(units, units());
    }

    @Test
    void sceneShownFromASolution_hasItsUnits() throws IOException {
        Solution room = Handmade.litRoom(Vec3.ZERO).solution();
        Solution lux = new Solution(room.scene().with(new Units(1, true)), room.channels(), room.positions(),
                room.irradiance(), room.corners(), room.faceOf(), 7, 5, .25, room.ledger(), SavedState.NONE);
        assertEquals(new Units(1, true), LitScene.of(lux, DefaultCamera.of(lux)).units());
    }

    /** Files of earlier versions do not say their units. */
    @Test
    void fileWithoutUnits_isRadiometricAndOfUnknownLength() throws IOException {
        write(new Units(.001, true));
        change(radiosity -> radiosity.remove("units"));
        assertEquals(Units.UNKNOWN, units());
    }

    @ParameterizedTest
    @CsvSource({"0", "-1"})
    void lengthThatIsNone_isRefusedInOneLine(double metres) throws IOException {
        write(new Units(1, true));
        change(radiosity -> ((ObjectNode) radiosity.get("units")).put("metres", metres));
        SceneFormatException wrong = assertThrows(SceneFormatException.class, this::units);
        assertEquals(file + ", JSON /asset/extras/radiosity/units/metres: expected a length above 0, got " + metres,
                wrong.getMessage());
    }
}
