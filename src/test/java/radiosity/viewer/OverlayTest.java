package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Text in the window: what does not fit in a line of a small window goes on below. */
class OverlayTest {

    @Test
    void longLines_goOnBelow_betweenWords() {
        String reason = "saved ed-edit-3.scene; ed.lws: expected a copy of the model that has the edited scene, got"
                + " block: expected a turn about its parent's vertical axis, as the parent is scaled unevenly";
        List<String> lines = Overlay.wrapped(reason).lines().toList();
        assertEquals(reason, String.join(" ", lines));
        assertTrue(lines.size() > 1 && lines.stream().allMatch(line -> line.length() <= 90), lines.toString());
        assertEquals("short", Overlay.wrapped("short"));
        assertTrue(Overlay.text(List.of(reason)).getWidth() < 800);
    }
}
