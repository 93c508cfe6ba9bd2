package radiosity.visibility;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.Test;

/**
 * What the JVM puts into what does not depend on the order in which it happens to compile: it goes by the bytes of
 * bytecode, as the JDK's javap prints them.
 */
class CompiledRaysTest {

    /** Methods of more bytes are not put into a caller: -XX:FreqInlineSize, the same on all processors that matter. */
    private static final int MOST = 325;

    @Test
    void raysOwnLoop_isNeverPutIntoACaller() {
        int bytes = bytes(RadiosityBounds.class, "blocker(float");
        assertTrue(bytes > MOST, "" + bytes);
    }

    @Test
    void triangleTest_isPutIntoTheLoop() {
        int bytes = bytes(PackedTriangle.class, "meets(");
        assertTrue(bytes <= MOST, "" + bytes);
    }

    /** Bytecode of a method, by how its declaration begins, or a byte or two less: where its last instruction begins. */
    private static int bytes(Class<?> of, String method) {
        String[] methods = javap(of).split("\n\n");
        for (String text : methods) {
            if (text.lines().findFirst().orElse("").contains(" " + method)) {
                Matcher at = Pattern.compile("(?m)^ +(\\d+): \\w").matcher(text);
                return at.results().mapToInt(found -> Integer.parseInt(found.group(1))).max().orElseThrow();
            }
        }
        throw new AssertionError("expected " + method + " in " + javap(of));
    }

    private static String javap(Class<?> of) {
        File classes = new File(of.getProtectionDomain().getCodeSource().getLocation().getPath());
        StringWriter out = new StringWriter();
        int code = ToolProvider.findFirst("javap").orElseThrow()
                .run(new PrintWriter(out), new PrintWriter(out), "-c", "-p", "-cp", classes.getPath(), of.getName());
        assertTrue(code == 0, out.toString());
        return out.toString();
    }
}
