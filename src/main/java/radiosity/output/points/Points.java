package radiosity.output.points;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import radiosity.mesh.face.Faces;
import radiosity.output.file.AtomicFile;
import radiosity.output.mesh.ClosestPoint;
import radiosity.output.mesh.ElementSearch;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.TJunctions;
import radiosity.scene.Rgb;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;

/** The light at points on surfaces, interpolated on the element that lies at the point on the side that is meant. */
public final class Points {

    private static final String HEADER = "x,y,z,nx,ny,nz,H_r,H_g,H_b,B_r,B_g,B_b\n";

    private final ElementSearch search;
    private final Solution solution;
    private final Faces faces;
    private final Solids solids;

    /** @param solution its T-junctions are closed here, as in the scene file; not modified */
    public Points(Solution solution) {
        this.solution = TJunctions.close(solution);
        search = new ElementSearch(this.solution);
        faces = new Faces(solution.scene());
        solids = new Solids(new RadiosityBounds(faces.occluders()), faces.fronts());
    }

    /**
     * Reads a file of points as {@link #write} does, to check it before a long render.
     *
     * @throws radiosity.scene.SceneFormatException for a line that is not six numbers with a normal, and for a file
     *         without points
     */
    public static void check(Path in) throws IOException {
        PointList.read(in, point -> { });
    }

    /**
     * Irradiance and radiosity at a point, NaN without an element there. Irradiance is 0 inside a solid, into which the
     * element of a floor may extend.
     *
     * @param normal of any length but 0, on the side that is meant
     */
    public Light at(Vec3 point, Vec3 normal) {
        return at(search.find(point, normal.unit()), point, normal);
    }

    /**
     * Irradiance and radiosity as {@link #at} gives them; where no element lies at the point, those at the place
     * nearest to it, up to 1e-3 of the scene's size away and seen from within 60 degrees of the normal.
     *
     * @param normal of any length but 0, on the side that is meant
     */
    public Light near(Vec3 point, Vec3 normal) {
        int element = search.find(point, normal.unit());
        int near = element < 0 ? search.nearest(point, normal.unit()) : -1;
        if (near < 0) {
            return at(element, point, normal);
        }
        double[] weight = new ClosestPoint(solution, near, point).weights();
        return at(near, Elements.point(solution, near, weight[1], weight[2]), normal);
    }

    private Light at(int element, Vec3 point, Vec3 normal) {
        if (element < 0) {
            Rgb none = Rgb.grey(Double.NaN);
            return new Light(none, none);
        }
        if (isInSolid(point, normal.unit())) {
            return new Light(Rgb.BLACK, solution.surface(element).exitance());
        }
        double[] weight = new ClosestPoint(solution, element, point).weights();
        Rgb h = Rgb.BLACK;
        for (int k = 0; k < 3; k++) {
            h = h.plus(solution.irradianceAt(solution.corners()[3 * element + k]).times(weight[k]));
        }
        Vec3 on = Elements.point(solution, element, weight[1], weight[2]);
        return new Light(h, solution.scene().material(solution.faceOf()[element] >> 1, on).radiosity(h));
    }

    /** Irradiance as {@link #at} gives it, W/m², but NaN inside a solid. */
    public Rgb outsideSolids(Vec3 point, Vec3 normal) {
        return isInSolid(point, normal.unit()) ? Rgb.grey(Double.NaN) : at(point, normal).irradiance();
    }

    private boolean isInSolid(Vec3 point, Vec3 n) {
        return solids.hold(faces.unit(point), n);
    }

    /**
     * The light at a point; NaN without an element there.
     *
     * @param irradiance H, W/m²
     * @param radiosity  B, W/m²
     */
    public record Light(Rgb irradiance, Rgb radiosity) {
    }

    /**
     * Reads points (columns x, y, z, nx, ny, nz) and writes them with the light at each, in the same order. Any number
     * of points is possible, because each is written before the next is read.
     *
     * @return number of points that lie on no surface; their light is written as nan
     * @throws radiosity.scene.SceneFormatException for a line that is not six numbers with a normal, and for a file
     *         without points
     */
    public long write(Path in, Path out) throws IOException {
        long[] missed = {0};
        AtomicFile.write(out, channel -> {
            Writer text = new BufferedWriter(new OutputStreamWriter(Channels.newOutputStream(channel),
                    StandardCharsets.US_ASCII));
            text.write(isPhotometric() ? HEADER.replace("\n", ",E_lx,L_cd_m2\n") : HEADER);
            PointList.read(in, point -> {
                Light light = near(new Vec3(point[0], point[1], point[2]), new Vec3(point[3], point[4], point[5]));
                text.append(line(point, light));
                missed[0] += Double.isNaN(light.irradiance().r()) ? 1 : 0;
            });
            text.flush();
        });
        return missed[0];
    }

    private boolean isPhotometric() {
        return solution.scene().units().isPhotometric();
    }

    private StringBuilder line(double[] point, Light light) {
        StringBuilder line = new StringBuilder();
        for (double x : point) {
            line.append(x).append(',');
        }
        append(line, light.irradiance()).append(',');
        append(line, light.radiosity());
        if (isPhotometric()) {
            Units units = solution.scene().units();
            line.append(',').append(text(units.total(light.irradiance()))).append(',')
                    .append(text(units.luminance(light.radiosity())));
        }
        return line.append('\n');
    }

    private static StringBuilder append(StringBuilder text, Rgb light) {
        return text.append(text(light.r())).append(',').append(text(light.g())).append(',').append(text(light.b()));
    }

    private static String text(double value) {
        return Double.isNaN(value) ? "nan" : String.valueOf(value);
    }
}
