package radiosity.input.photometry;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.StringTokenizer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.SceneFormatException;
import radiosity.util.Decimal;

/**
 * Reads IES LM-63 of 1986, 1991, 1995, 2002 and 2019.
 *
 * <p>Sources: ANSI/IES LM-63-19; for older editions I. Ashdown, Parsing the IESNA LM-63 photometric data file, 1998.
 */
final class IesParser {

    private static final Pattern TILT = Pattern.compile("(?im)^[ \\t]*TILT[ \\t]*=[ \\t]*([^\\r\\n]*)$");
    private static final double FOOT = 0.3048;
    private static final double ROUNDING = 1e-6;

    private final String name;
    private final Photometry.Sibling siblings;
    /** Whether the ballast-lamp photometric factor multiplies the flux; editions after 1991 use its place otherwise. */
    private final boolean isOld;
    private final String tilt;
    private StringTokenizer numbers;
    private String what = "TILT=";

    IesParser(String text, String name, Photometry.Sibling siblings) {
        this.name = name;
        this.siblings = siblings;
        String first = text.lines().findFirst().orElse("").strip().toUpperCase(Locale.ROOT);
        isOld = !first.startsWith("IES") || first.startsWith("IESNA91") || first.startsWith("IESNA:LM-63-1986")
                || first.startsWith("IESNA:LM-63-1991");
        Matcher found = TILT.matcher(text);
        boolean there = found.find();
        tilt = there ? found.group(1).strip() : null;
        numbers = tokens(there ? text.substring(found.end()) : "");
    }

    /** Whether a text is in this format, valid or not; EULUMDAT begins with a company's name, which may be IES, too. */
    static boolean isIes(String text) {
        return TILT.matcher(text).find() || text.startsWith("IES") && !EulumdatParser.isEulumdat(text);
    }

    private static StringTokenizer tokens(String text) {
        return new StringTokenizer(text, " ,\t\r\n\f\u001a");
    }

    Photometry photometry() throws IOException {
        if (tilt == null) {
            throw wrong("a line that begins with TILT=", "none");
        }
        Photometry.Tilt tilting = tilting();
        number("number of lamps");
        number("lumens per lamp");
        double factor = atLeastZero("candela multiplier");
        int verticals = count("number of vertical angles");
        int horizontals = count("number of horizontal angles");
        int type = count("photometric type");
        int units = count("units type");
        if (type > 3 || units > 2) {
            throw wrong("photometric type 1, 2 or 3 and units type 1 or 2", type + " and " + units);
        }
        double width = number("width");
        double length = number("length");
        number("height");
        factor *= atLeastZero("ballast factor");
        double second = number("ballast-lamp photometric factor");
        factor *= isOld ? second : 1;
        number("input watts");
        if ((long) verticals * horizontals > numbers.countTokens()) {
            throw wrong(verticals + " x " + horizontals + " intensities", numbers.countTokens() + " numbers");
        }
        double[] v = numbers(verticals, "vertical angles");
        double[] h = numbers(horizontals, "horizontal angles");
        double[] candela = numbers(verticals * horizontals, "intensities");
        for (int i = 0; i < candela.length; i++) {
            candela[i] *= factor;
        }
        double metre = units == 1 ? FOOT : 1;
        boolean round = width < 0;
        double scale = metre * (round ? Photometry.ROUND : 1);
        return new Photometry(web(type, h, v, candela), Math.abs(round && length == 0 ? width : length) * scale,
                Math.abs(width) * scale, tilting);
    }

    private static double largestStep(double[] angles) {
        double largest = 0;
        for (int i = 1; i < angles.length; i++) {
            largest = Math.max(largest, angles[i] - angles[i - 1]);
        }
        return largest;
    }

    private LuminousIntensity web(int type, double[] h, double[] v, double[] candela) throws SceneFormatException {
        Web web = new Web(h, v, candela);
        double first = h[0];
        double last = h[h.length - 1];
        if (type == 1) {
            range(v, 0, 180, "vertical");
            if (h.length > 1 && is(first, 90) && is(last, 270)) {
                return web.mirroredAtNinety();
            }
            range(h, 0, 360, "horizontal");
            if (!is(first, 0)) {
                throw wrong("horizontal angles from 0, or from 90 to 270", "from " + first);
            }
            if (h.length == 1 || is(last, 90) || is(last, 180)) {
                return h.length == 1 ? web.axial() : is(last, 90) ? web.quadrants() : web.halves();
            }
            boolean is360LeftOut = 360 - last <= 1.5 * largestStep(h); // the plane of 360 degrees is that of 0
            if (!is360LeftOut && !is(last, 360)) {
                throw wrong("horizontal angles up to 90, 180 or 360", "up to " + last);
            }
            return web.whole();
        }
        range(v, -90, 90, "vertical");
        range(h, -90, 90, "horizontal");
        boolean sound = (is(v[0], 0) || is(v[0], -90)) && (is(first, 0) || is(first, -90));
        if (!sound) {
            throw wrong("angles that begin with 0 or -90", "horizontal " + first + ", vertical " + v[0]);
        }
        return web.turned(type == 2 ? LuminousIntensity.Type.B : LuminousIntensity.Type.A);
    }

    private static boolean is(double angle, double other) {
        return Math.abs(angle - other) < ROUNDING;
    }

    private void range(double[] angles, double least, double most, String kind) throws SceneFormatException {
        if (angles[0] < least - ROUNDING || angles[angles.length - 1] > most + ROUNDING) {
            throw wrong(kind + " angles from " + least + " to " + most, angles[0] + " to " + angles[angles.length - 1]);
        }
    }

    private Photometry.Tilt tilting() throws IOException {
        if (tilt.equalsIgnoreCase("NONE")) {
            return Photometry.Tilt.NONE;
        }
        StringTokenizer rest = numbers;
        if (!tilt.equalsIgnoreCase("INCLUDE")) {
            String missing = "nothing of that name";
            numbers = tokens(new String(siblings.read(tilt).orElseThrow(() -> wrong("the file " + tilt + " beside it",
                    missing)), StandardCharsets.ISO_8859_1));
        }
        count("lamp-to-luminaire geometry");
        int pairs = count("number of tilt angles");
        if (2L * pairs > numbers.countTokens()) {
            throw wrong(pairs + " tilt angles and factors", numbers.countTokens() + " numbers");
        }
        double[] angles = numbers(pairs, "tilt angles");
        double[] factors = numbers(pairs, "tilt factors");
        if (Arrays.stream(factors).anyMatch(f -> f < 0)) {
            throw wrong("tilt factors of at least 0", Arrays.toString(factors));
        }
        if (!tilt.equalsIgnoreCase("INCLUDE")) {
            numbers = rest;
        }
        return new Photometry.Tilt(angles, factors);
    }

    private double[] numbers(int count, String of) throws SceneFormatException {
        double[] values = new double[count];
        for (int i = 0; i < count; i++) {
            values[i] = number(of);
            if (of.endsWith("angles") && i > 0 && !(values[i] > values[i - 1])) {
                throw wrong(of + " that ascend", values[i - 1] + ", " + values[i]);
            }
        }
        return values;
    }

    private double atLeastZero(String of) throws SceneFormatException {
        double value = number(of);
        if (value < 0) {
            throw wrong("a " + of + " of at least 0", String.valueOf(value));
        }
        return value;
    }

    private int count(String of) throws SceneFormatException {
        double value = number(of);
        if (!(value >= 1 && value <= Integer.MAX_VALUE && value == Math.rint(value))) {
            throw wrong("a whole number of at least 1 for " + of, String.valueOf(value));
        }
        return (int) value;
    }

    private double number(String of) throws SceneFormatException {
        what = of;
        String text = numbers.hasMoreTokens() ? numbers.nextToken() : "the end of the file";
        double value = Decimal.parse(text);
        if (Double.isNaN(value)) {
            throw wrong("a number", text);
        }
        return value;
    }

    private SceneFormatException wrong(String expected, String got) {
        return new SceneFormatException(name, what, expected, got.length() > 80 ? got.substring(0, 80) : got);
    }
}
