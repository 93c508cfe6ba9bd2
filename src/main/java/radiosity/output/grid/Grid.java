package radiosity.output.grid;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import radiosity.output.file.AtomicFile;
import radiosity.output.points.Points;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.ParallelFor;

/**
 * Illuminance (irradiance in radiometric scenes) on a grid of points, and the figures that EN 12464-1 asks for.
 *
 * @param where    the surface or plane of the grid, as the user named it
 * @param rows     x, y, z, nx, ny, nz and illuminance of each point: 7 numbers
 * @param mean     average illuminance over the area for which points stand; NaN where there is no point, as the next
 *                 two
 * @param minimum  least illuminance
 * @param maximum  largest illuminance
 * @param left     number of points left out: inside solids, or outside of rooms
 * @param quantity name of the quantity, and its unit
 * @param daylight the daylight factors; empty where anything but an overcast sky lights the scene
 */
public record Grid(String where, double[][] rows, double mean, double minimum, double maximum, int left,
                   String[] quantity, Optional<DaylightFactor> daylight) {

    /**
     * Checks that a grid can be made, before a long render.
     *
     * @throws IllegalArgumentException if there is no surface of the name, the plane is outside the scene, or there are
     *         too many points
     */
    public static void check(Scene scene, String where, double spacing) {
        GridPlaces.of(scene, where, spacing);
    }

    /**
     * Calculates a grid.
     *
     * @param where   the name of a surface, for its visible side; or a plane, x, y or z = a number, for its side
     *                towards larger numbers, or with - before it for the other side
     * @param spacing approximate distance of neighbouring points, scene units, above 0
     * @param threads at least 1
     * @throws IllegalArgumentException as {@link #check}
     */
    public static Grid of(Solution solution, String where, double spacing, int threads) {
        GridPlaces places = GridPlaces.of(solution.scene(), where, spacing);
        Units units = solution.scene().units();
        Points points = new Points(solution);
        FreeIrradiance free = places.onSurface() ? null : new FreeIrradiance(solution, points);
        double[][] rows = new double[places.points().size()][];
        new ParallelFor(threads).run(rows.length, i -> {
            Vec3 p = places.points().get(i);
            Vec3 n = places.normals().get(i);
            Rgb light = free == null ? points.outsideSolids(p, n) : free.at(p, n);
            rows[i] = new double[] {p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), units.total(light)};
        });
        int[] lit = IntStream.range(0, rows.length).filter(i -> !Double.isNaN(rows[i][6])).toArray();
        double area = 0;
        double flux = 0;
        for (int i : lit) {
            area += places.areas().get(i);
            flux += places.areas().get(i) * rows[i][6];
        }
        double mean = flux / area;
        int[] rising = IntStream.of(lit).boxed().sorted(Comparator.comparingDouble(i -> rows[i][6]))
                .mapToInt(i -> i).toArray();
        return new Grid(where, IntStream.of(lit).mapToObj(i -> rows[i]).toArray(double[][]::new), mean,
                rising.length == 0 ? Double.NaN : rows[rising[0]][6],
                rising.length == 0 ? Double.NaN : rows[rising[rising.length - 1]][6], rows.length - lit.length,
                new String[] {units.irradianceWord(), units.irradiance()}, DaylightFactor.of(solution.scene(),
                        IntStream.of(rising).mapToDouble(i -> rows[i][6]).toArray(),
                        IntStream.of(rising).mapToDouble(i -> places.areas().get(i)).toArray(), mean));
    }

    /** Uniformity U0: minimum over average; 0 if all is dark, NaN if there is no point. */
    public double uniformity() {
        return mean == 0 ? 0 : minimum / mean;
    }

    /** The figures in one line of text. */
    public String summary() {
        if (rows.length == 0) {
            return where + ": no points, as " + left + " inside solids or outside are left out: on a plane that"
                    + " lies on a surface give the surface's name, where faces look both ways give --two-sided (of"
                    + " OBJ), in a small room a smaller --spacing";
        }
        return String.format(Locale.ROOT, "%s: average %s %.4g %s, minimum %.4g, maximum %.4g, uniformity U0 %.2f, %d"
                + " point%s", where, quantity[0], mean, quantity[1], minimum, maximum, uniformity(), rows.length,
                rows.length == 1 ? "" : "s")
                + daylight.map(d -> ", " + d.summary()).orElse("")
                + (left > 0 ? " (" + left + " inside solids or outside are left out)" : "");
    }

    /** Writes a table: lines that begin with # and have the figures of the grid, a header, then one line per point. */
    public void write(Path file) throws IOException {
        AtomicFile.write(file, channel -> {
            Writer text = new BufferedWriter(new OutputStreamWriter(Channels.newOutputStream(channel),
                    StandardCharsets.UTF_8));
            text.append(heading());
            for (double[] row : rows) {
                for (int i = 0; i < row.length; i++) {
                    text.append(i == 0 ? "" : ",").append(String.valueOf(row[i] == 0 ? 0.0 : row[i]));
                }
                if (daylight.isPresent()) {
                    text.append(',').append(String.valueOf(daylight.get().percent(row[6])));
                }
                text.append('\n');
            }
            text.flush();
        });
    }

    private StringBuilder heading() {
        StringBuilder text = new StringBuilder();
        text.append("# ").append(where.replaceAll("\\p{Cntrl}", " ")).append('\n');
        text.append("# average ").append(quantity[0]).append(',').append(mean).append(',').append(quantity[1]);
        text.append("\n# minimum ").append(quantity[0]).append(',').append(minimum).append(',').append(quantity[1]);
        text.append("\n# maximum ").append(quantity[0]).append(',').append(maximum).append(',').append(quantity[1]);
        text.append("\n# uniformity U0 (minimum / average),").append(uniformity()).append("\n# diversity (minimum /"
                + " maximum),").append(maximum == 0 ? 0 : minimum / maximum).append("\n# points,").append(rows.length);
        daylight.ifPresent(d -> text.append("\n# daylight factor average,").append(d.average())
                .append(",%\n# daylight factor median,").append(d.median())
                .append(",%\n# daylight factor that 95 % of the area exceeds,").append(d.exceeded()).append(",%"));
        return text.append("\nx,y,z,nx,ny,nz,E_").append(quantity[1].replace("/", "_"))
                .append(daylight.isPresent() ? ",DF_percent\n" : "\n");
    }
}
