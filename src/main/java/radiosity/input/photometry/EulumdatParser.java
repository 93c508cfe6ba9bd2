package radiosity.input.photometry;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.SceneFormatException;
import radiosity.util.Decimal;

/**
 * Reads EULUMDAT: a number or a text per line.
 *
 * <p>Source: A. Stockmar, EULUMDAT - ein Leuchtendatenformat für den europäischen Beleuchtungsplaner, Licht '90,
 * 1990. Of several sets of lamps, which are alternatives, the first is used.
 */
final class EulumdatParser {

    private static final int MOST_PLANES = 721;
    private static final int MOST_ANGLES = 3601;
    private static final int MOST_SETS = 20;
    /** Number of lines: before the sets of lamps, of a set, of the direct ratios. */
    private static final int HEADER = 26;
    private static final int SET = 6;
    private static final int RATIOS = 10;
    private static final double MILLIMETRE = 1e-3;

    private final String name;
    private final List<String> lines;

    EulumdatParser(String text, String name) {
        this.name = name;
        lines = text.lines().map(String::strip).toList();
    }

    /** Whether a text may be in this format, valid or not: one of three numbers is where it belongs. */
    static boolean isEulumdat(String text) {
        EulumdatParser parser = new EulumdatParser(text, "");
        return IntStream.of(3, 4, 6).anyMatch(line -> !Double.isNaN(parser.decimal(line)));
    }

    Photometry photometry() throws SceneFormatException {
        int symmetry = whole(3, "symmetry", 0, 4);
        int planes = whole(4, "number of C planes", 1, MOST_PLANES);
        int angles = whole(6, "number of intensities in a C plane", 2, MOST_ANGLES);
        int sets = whole(HEADER, "number of sets of lamps", 1, MOST_SETS);
        double lamps = number(HEADER + 1, "number of lamps");
        double flux = number(HEADER + 3, "flux of the lamps");
        double factor = flux / 1000 * number(24, "conversion factor");
        if (lamps == 0 || !(flux > 0)) {
            throw wrong(HEADER + 3, "lamps with flux", lamps + " lamps of " + flux + " lm");
        }
        int c = HEADER + sets * SET + RATIOS + 1;
        int gamma = c + planes;
        int first = gamma + angles;
        int[] listed = listed(symmetry, planes);
        double[] horizontal = new double[listed.length];
        double[] candela = new double[listed.length * angles];
        for (int i = 0; i < listed.length; i++) {
            horizontal[i] = number(c + listed[i], "angle of a C plane");
            if (horizontal[i] < 0 || horizontal[i] > 360) {
                throw wrong(c + listed[i], "an angle from 0 to 360", String.valueOf(horizontal[i]));
            }
        }
        double[] vertical = new double[angles];
        for (int k = 0; k < angles; k++) {
            vertical[k] = number(gamma + k, "angle in a C plane");
            if (vertical[k] < 0 || vertical[k] > 180 || k > 0 && vertical[k] <= vertical[k - 1]) {
                throw wrong(gamma + k, "angles that ascend from 0 to 180", String.valueOf(vertical[k]));
            }
        }
        for (int i = 0; i < candela.length; i++) {
            candela[i] = factor * number(first + i, "intensity");
        }
        return photometry(web(symmetry, new Web(horizontal, vertical, candela)));
    }

    private static LuminousIntensity web(int symmetry, Web web) {
        return switch (symmetry) {
            case 1 -> web.axial();
            case 2 -> web.halves();
            case 3 -> web.mirroredAtNinety();
            case 4 -> web.quadrants();
            default -> web.whole();
        };
    }

    /** Indices of the C planes whose intensities the file lists; their number follows from the symmetry. */
    private int[] listed(int symmetry, int planes) throws SceneFormatException {
        int parts = symmetry == 4 || symmetry == 3 ? 4 : symmetry == 2 ? 2 : 1;
        if (planes % parts != 0) {
            throw wrong(4, "a number of C planes that " + parts + " divides, for symmetry " + symmetry,
                    String.valueOf(planes));
        }
        return switch (symmetry) {
            case 1 -> new int[] {0};
            case 2 -> IntStream.rangeClosed(0, planes / 2).toArray();
            case 3 -> IntStream.rangeClosed(3 * planes / 4, 5 * planes / 4).map(i -> i % planes).toArray();
            case 4 -> IntStream.rangeClosed(0, planes / 4).toArray();
            default -> IntStream.range(0, planes).toArray();
        };
    }

    /**
     * The file's length of the opening is across the plane C0, its width in it; an opening without width is a circle.
     */
    private Photometry photometry(LuminousIntensity intensity) throws SceneFormatException {
        double length = size(16) * MILLIMETRE;
        double width = size(17) * MILLIMETRE;
        double side = width > 0 ? length : length * Photometry.ROUND;
        return new Photometry(intensity, width > 0 ? width : side, side, Photometry.Tilt.NONE);
    }

    /** A length, at least 0; 0 where the line is empty. */
    private double size(int line) throws SceneFormatException {
        return text(line).isEmpty() ? 0 : Math.max(0, number(line, "size of the luminous area"));
    }

    private int whole(int line, String what, int least, int most) throws SceneFormatException {
        double value = number(line, what);
        if (value != Math.rint(value) || value < least || value > most) {
            throw wrong(line, what + " from " + least + " to " + most, text(line));
        }
        return (int) value;
    }

    private double number(int line, String what) throws SceneFormatException {
        double value = decimal(line);
        if (Double.isNaN(value)) {
            throw wrong(line, "a number (" + what + ")", Optional.of(text(line)).filter(t -> !t.isEmpty())
                    .orElse(line > lines.size() ? "the end of the file" : "nothing"));
        }
        return value;
    }

    private double decimal(int line) {
        return Decimal.parse(text(line).replace(',', '.'));
    }

    private String text(int line) {
        return line > lines.size() ? "" : lines.get(line - 1);
    }

    private SceneFormatException wrong(int line, String expected, String got) {
        return new SceneFormatException(name, "line " + line, expected, got.length() > 80 ? got.substring(0, 80) : got);
    }
}
