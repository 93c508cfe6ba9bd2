package radiosity.output.points;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;
import radiosity.util.Decimal;

/**
 * Reads points on surfaces, each with the normal of the side that is meant, from a text file of columns.
 *
 * <p>A header may name the columns x, y, z, nx, ny, nz in any order, among others; without a header they are the first
 * six. Columns are separated by commas, semicolons or tabs. Without a header that names the columns, other lines before
 * the numbers are left out; so are, always, empty lines and lines that begin with #.
 */
final class PointList {

    private static final List<String> COLUMNS = List.of("x", "y", "z", "nx", "ny", "nz");

    private final String name;
    private final Taker taker;
    private int[] column = {0, 1, 2, 3, 4, 5};
    /** Whether every further line is a point: after a header that names the columns, and after the first number. */
    private boolean isBegun;
    private boolean isEmpty = true;
    private int line;

    private PointList(String name, Taker taker) {
        this.name = name;
        this.taker = taker;
    }

    /** Is given the points, one after the other. */
    interface Taker {

        /** @param point x, y, z, nx, ny, nz */
        void take(double[] point) throws IOException;
    }

    /**
     * Reads any number of points and keeps none of them.
     *
     * @throws SceneFormatException for a line that is not six numbers with a normal, and for a file without points
     */
    static void read(Path file, Taker taker) throws IOException {
        PointList points = new PointList(file.toString(), taker);
        try (BufferedReader reader = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
            for (String text = reader.readLine(); text != null; text = reader.readLine()) {
                points.add(text.replace("\ufeff", "").strip());
            }
        } catch (MalformedInputException e) {
            throw new SceneFormatException(file.toString(), "", "text", "something else");
        }
        if (points.isEmpty) {
            throw new SceneFormatException(file.toString(), "", "points, as x, y, z, nx, ny, nz per line", "none");
        }
    }

    private void add(String text) throws IOException {
        line++;
        if (text.isEmpty() || text.startsWith("#")) {
            return;
        }
        String[] fields = fields(text);
        if (!isBegun && Double.isNaN(Decimal.parse(fields[0])) && !fields[0].equalsIgnoreCase("nan")) {
            header(fields);
            return;
        }
        isBegun = true;
        isEmpty = false;
        double[] point = new double[6];
        for (int i = 0; i < 6; i++) {
            point[i] = number(fields, i);
        }
        if (!(new Vec3(point[3], point[4], point[5]).length() > 0)) {
            throw wrong("a normal longer than 0", text);
        }
        taker.take(point);
    }

    /** The fields of a line; where there are semicolons or tabs, a comma is that of a number. */
    private static String[] fields(String text) {
        boolean hasCommas = text.indexOf(';') < 0 && text.indexOf('\t') < 0;
        return Arrays.stream((hasCommas ? text : text.replace(',', '.')).split(hasCommas ? "," : "[;\t]", -1))
                .map(field -> field.strip().replaceAll("^\"(.*)\"$", "$1").strip()).toArray(String[]::new);
    }

    private void header(String[] fields) throws SceneFormatException {
        List<String> names = Arrays.stream(fields)
                .map(f -> f.strip().replace("\"", "").toLowerCase(Locale.ROOT)).toList();
        int[] found = COLUMNS.stream().mapToInt(names::indexOf).toArray();
        long count = Arrays.stream(found).filter(i -> i >= 0).count();
        if (count == 6) {
            column = found;
            isBegun = true;
        } else if (count > 0) {
            throw wrong("columns " + String.join(",", COLUMNS), String.join(",", names));
        }
    }

    private double number(String[] fields, int i) throws SceneFormatException {
        String field = column[i] < fields.length ? fields[column[i]].strip() : "nothing";
        double number = Decimal.parse(field);
        if (Double.isNaN(number)) {
            throw wrong("a number for " + COLUMNS.get(i), field);
        }
        return number;
    }

    private SceneFormatException wrong(String expected, String got) {
        return new SceneFormatException(name, "line " + line, expected, got);
    }
}
