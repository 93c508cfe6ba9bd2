package radiosity.testkit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Points of a scene and their radiosities as path tracing found them ({@code truth/NAME.csv}).
 *
 * @param rows per point: number, surface, x, y, z, nx, ny, nz, area it stands for (m²), tag, radiosity in red, green
 *             and blue (W/m²), their standard errors
 */
public record TruthFile(double[][] rows) {

    private static final int POSITION = 2;
    private static final int WEIGHT = 8;
    private static final int TAG = 9;
    private static final int RADIOSITY = 10;
    private static final int NOISE = 13;

    public static TruthFile read(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file);
        return new TruthFile(lines.stream().skip(1).map(TruthFile::numbers).toArray(double[][]::new));
    }

    private static double[] numbers(String line) {
        String[] words = line.split(",");
        double[] row = new double[words.length];
        for (int i = 0; i < row.length; i++) {
            row[i] = Double.parseDouble(words[i]);
        }
        return row;
    }

    public int size() {
        return rows.length;
    }

    /** @return x, y, z, nx, ny, nz of each point, 6 per point */
    public double[] places() {
        double[] places = new double[6 * rows.length];
        for (int i = 0; i < rows.length; i++) {
            System.arraycopy(rows[i], POSITION, places, 6 * i, 6);
        }
        return places;
    }

    /** True radiosity of a point in a channel, W/m². */
    public double radiosity(int point, int channel) {
        return rows[point][RADIOSITY + channel];
    }

    /**
     * Adds one channel of the points of a set.
     *
     * @param found radiosities to judge, 3 per point, W/m²; what is not finite counts as 0
     * @param unit  what they are divided by
     */
    void add(Score.Sums sums, PointSet set, int channel, double[] found, double unit) {
        for (int i = 0; i < rows.length; i++) {
            double weight = set.weight(rows[i][WEIGHT], (int) rows[i][TAG]);
            double value = found[3 * i + channel];
            if (weight >= 0) {
                sums.add(weight, radiosity(i, channel) / unit, (Double.isFinite(value) ? value : 0) / unit,
                        rows[i][NOISE + channel] / unit);
            }
        }
    }
}
