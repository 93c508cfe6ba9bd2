package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Lamp;
import radiosity.scene.Rgb;

class LampMixTest {

    private static final List<Lamp> LAMPS = List.of(new Lamp("spot", false, 0), new Lamp("ceiling lamp", true, 3),
            new Lamp("spot", false, 1));
    private static final LampMix RENDERED = LampMix.asRendered(LAMPS);
    private static final Rgb WARM = new Rgb(.5, .4, .1);

    @Test
    void lampsOfOneName_areSetTogether() {
        assertEquals(List.of("spot", "ceiling lamp"), RENDERED.groups());
        assertEquals(List.of(WARM, Rgb.grey(1), WARM), RENDERED.with(0, WARM).factors());
        assertEquals(List.of(WARM, Rgb.BLACK, WARM), RENDERED.with(0, WARM).only(0).factors());
        assertEquals(List.of(Rgb.BLACK, Rgb.grey(1), Rgb.BLACK), RENDERED.with(1, Rgb.BLACK).only(1).factors());
        assertTrue(RENDERED.with(0, WARM).with(0, Rgb.grey(1)).isAsRendered());
    }

    @Test
    void text_isReadBack() throws IOException {
        LampMix mix = RENDERED.with(0, WARM).with(1, Rgb.BLACK);
        assertEquals("0.5 0.4 0.1 spot\n0.0 0.0 0.0 ceiling lamp\n", mix.text());
        assertEquals(mix, RENDERED.only(1).read(mix.text(), "a.mix"));
        assertTrue(mix.read("2 2 2 another lamp\r\n", "a.mix").isAsRendered(), "what is not named is as rendered");
    }

    @Test
    void anyName_isReadBack() throws IOException {
        LampMix rendered = LampMix.asRendered(List.of(new Lamp("", false, 0), new Lamp(" two  words ", false, 1)));
        LampMix mix = rendered.with(0, WARM).with(1, Rgb.BLACK);
        assertEquals(mix, rendered.read(mix.text(), "a.mix"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "1 1 spot", "1 1 1", "-1 1 1 spot", "NaN 1 1 spot", "1e999 1 1 spot", "{\"a\": 1}"})
    void otherTexts_areRefused(String text) {
        assertTrue(assertThrows(IOException.class, () -> RENDERED.read(text, "a.mix")).getMessage()
                .startsWith("a.mix, line 1: expected three factors and a lamp's name"));
    }
}
