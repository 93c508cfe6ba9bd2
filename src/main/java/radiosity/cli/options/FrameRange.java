package radiosity.cli.options;

import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * Range of frames of an animation.
 *
 * @param first at least 0
 * @param last  at least {@code first}
 * @param step  from one frame to the next, at least 1
 */
public record FrameRange(int first, int last, int step) {

    private static final Pattern TEXT = Pattern.compile("(\\d{1,6})-(\\d{1,6})(?::(\\d{1,6}))?");

    /** Parses {@code 0-100} and {@code 0-100:2}. */
    static final class Parser extends Values.Value<FrameRange> {

        @Override
        String expected() {
            return "frames like 0-100 or 0-100:2";
        }

        @Override
        public FrameRange parse(String text) {
            Matcher words = TEXT.matcher(text);
            if (!words.matches()) {
                return null;
            }
            FrameRange range = new FrameRange(Integer.parseInt(words.group(1)), Integer.parseInt(words.group(2)),
                    words.group(3) == null ? 1 : Integer.parseInt(words.group(3)));
            return range.last >= range.first && range.step > 0 ? range : null;
        }
    }

    /** The numbers of all frames, ascending. */
    public int[] all() {
        return IntStream.rangeClosed(0, (last - first) / step).map(i -> first + i * step).toArray();
    }

    /** A file name with the number of a frame inserted before its extension: {@code room-0012.scene}. */
    static Path numbered(Path file, int frame) {
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        String number = String.format(Locale.ROOT, "-%04d", frame);
        return file.resolveSibling(dot <= 0 ? name + number : name.substring(0, dot) + number + name.substring(dot));
    }
}
