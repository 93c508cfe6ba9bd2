package radiosity.input.obj;

import java.util.Locale;
import java.util.Map;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSniffer;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;

/** Reads diffuse reflectance and emission of the materials in a material library (MTL). */
final class MtlParser {

    private static final int MOST_MATERIALS = 1 << 16;
    /** Options of images with a fixed number of words after them; -o, -s and -t have up to 3 numbers. */
    private static final Map<String, Integer> OPTIONS = Map.of("-blendu", 1, "-blendv", 1, "-boost", 1, "-mm", 2,
            "-texres", 1, "-bm", 1, "-imfchan", 1, "-type", 1, "-cc", 1);

    private final TextLines lines;
    private final Diagnostics notes;
    private final Map<String, Material> materials;

    private MtlParser(TextLines lines, Diagnostics notes, Map<String, Material> materials) {
        this.lines = lines;
        this.notes = notes;
        this.materials = materials;
    }

    /**
     * Adds the materials of a library; of several materials with one name the first is kept.
     *
     * @param file      not modified
     * @param materials by name; modified
     * @throws SceneFormatException if the library is in UTF-16, or has too many materials
     */
    static void parse(byte[] file, Diagnostics notes, Map<String, Material> materials) throws SceneFormatException {
        if (FileSniffer.isUtf16(file)) {
            throw notes.error("", "a material library in UTF-8 or ASCII", "text in UTF-16");
        }
        new MtlParser(new TextLines(file), notes, materials).parse();
    }

    private void parse() throws SceneFormatException {
        Material material = new Material("", false);
        while (lines.next()) {
            String keyword = lines.word();
            switch (keyword.toLowerCase(Locale.ROOT)) {
                case "newmtl" -> material = begin(lines.rest());
                case "kd" -> material.diffuse = colour(material.diffuse);
                case "ke" -> material.emitted = colour(material.emitted);
                case "map_kd" -> material.diffuseImage = image();
                case "map_ke", "map_emissive" -> material.emittedImage = image();
                case "d" -> material.opacity = opacity();
                case "tr" -> material.transparency = lines.number("0");
                case "map_d" -> material.hasOpacityImage = true;
                default -> { }
            }
        }
    }

    /** The opacity of a surface; after {@code -halo}, that of a surface seen head on. */
    private double opacity() {
        String first = lines.word();
        return first.equals("-halo") ? lines.number("1") : TextLines.number(first.isEmpty() ? "1" : first, Double.NaN);
    }

    private Material begin(String name) throws SceneFormatException {
        if (materials.size() >= MOST_MATERIALS) {
            throw notes.error(lines.place(), "at most " + MOST_MATERIALS + " materials", "more");
        }
        Material material = new Material(name, true);
        if (materials.putIfAbsent(name, material) != null) {
            notes.note(lines.place(), "of several materials of one name the first counts", name);
        }
        return material;
    }

    /** Reads three numbers, or one number for all channels. */
    private Rgb colour(Rgb before) {
        String first = lines.word();
        if (first.equals("spectral") || first.equals("xyz")) {
            notes.note(lines.place(), "colours in other terms than red, green and blue are left out", first);
            return before;
        }
        double r = TextLines.number(first, Double.NaN);
        double g = lines.number(first);
        double b = lines.number(first);
        if (!(r >= 0 && g >= 0 && b >= 0) || !new Rgb(r, g, b).isFinite()) {
            notes.note(lines.place(), "colours that are not numbers of at least 0 are left out",
                    r + " " + g + " " + b);
            return before;
        }
        return new Rgb(r, g, b);
    }

    /** Reads options, then the path, which may contain blanks. */
    private TextureImage image() {
        double[] scale = {1, 1};
        double[] offset = new double[2];
        boolean clamp = false;
        String path = lines.rest();
        while (path.startsWith("-")) {
            String option = lines.word();
            if (option.equals("-o") || option.equals("-s") || option.equals("-t")) {
                numbers(option.equals("-s") ? scale : option.equals("-o") ? offset : new double[2]);
            } else if (option.equals("-clamp")) {
                clamp = lines.word().equals("on");
            } else if (OPTIONS.containsKey(option)) {
                for (int i = 0; i < OPTIONS.get(option); i++) {
                    lines.word();
                }
            } else {
                return new TextureImage(path, scale[0], scale[1], offset[0], offset[1], clamp);
            }
            path = lines.rest();
        }
        return new TextureImage(TextLines.unquoted(path), scale[0], scale[1], offset[0], offset[1], clamp);
    }

    /** Reads up to three numbers and keeps the first two. */
    private void numbers(double[] into) {
        for (int i = 0; i < 3; i++) {
            String rest = lines.rest();
            double value = TextLines.number(rest.split("\\s", 2)[0], Double.NaN);
            if (!Double.isFinite(value)) {
                return;
            }
            lines.word();
            if (i < 2) {
                into[i] = value;
            }
        }
    }
}
