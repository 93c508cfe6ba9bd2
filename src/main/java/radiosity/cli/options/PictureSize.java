package radiosity.cli.options;

/**
 * Size of a picture in pixels.
 *
 * @param width  1 to {@value #MOST}
 * @param height 1 to {@value #MOST}
 */
public record PictureSize(int width, int height) {

    /** Largest width and height: the pixels of such a picture still fit into an array. */
    public static final int MOST = 16384;

    /** Parses {@code 640x480}. */
    static final class Parser extends Values.Value<PictureSize> {
        @Override
        String expected() {
            return "a size such as 640x480, each at most " + MOST;
        }

        @Override
        public PictureSize parse(String text) {
            String[] edges = text.split("x", -1);
            Integer width = Values.whole(edges[0], 1, MOST);
            Integer height = edges.length == 2 ? Values.whole(edges[1], 1, MOST) : null;
            return width == null || height == null ? null : new PictureSize(width, height);
        }
    }
}
