package radiosity.input.file;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import radiosity.scene.SceneFormatException;

/** One line per kind of remark, whatever a file holds. */
class DiagnosticsTest {

    private final List<String> lines = new ArrayList<>();
    private final Diagnostics remarks = new Diagnostics("a.obj", lines::add, false);

    private String lineOf(String... details) throws SceneFormatException {
        for (String detail : details) {
            remarks.note("line 7", "left out", detail);
        }
        remarks.flush();
        return lines.remove(0);
    }

    @Test
    void line_namesTheFirstDifferentDetails() throws SceneFormatException {
        assertEquals("a.obj, line 7: left out", lineOf(""));
        assertEquals("a.obj, line 7: left out (2 times)", lineOf("", ""));
        assertEquals("a.obj, line 7: left out: oak", lineOf("oak"));
        assertEquals("a.obj, line 7: left out: oak, ash (3 times)", lineOf("oak", "ash", "oak"));
        assertEquals("a.obj, line 7: left out: 0, 1, 2, 3, 4, ... (9 times)",
                lineOf(IntStream.range(0, 9).mapToObj(Integer::toString).toArray(String[]::new)));
    }

    @Test
    void longDetails_makeNoLongLine() throws SceneFormatException {
        String oak = "oak".repeat(50);
        String ash = "ash".repeat(50);
        assertEquals("a.obj, line 7: left out: " + oak + ", ... (2 times)", lineOf(oak, ash));
    }
}
