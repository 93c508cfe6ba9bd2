package radiosity.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import radiosity.patch.Faces;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;
import radiosity.world.Solution;

/** The light at points on surfaces, interpolated on the element that is there on the side that is asked for. */
public final class Points {

    private static final String HEADER = "x,y,z,nx,ny,nz,H_r,H_g,H_b,B_r,B_g,B_b\n";

    private final ElementSearch search;
    private final Solution solution;
    private final Faces faces;
    private final Solids solids;

    /** @param solution T-junctions are closed here, as in the scene file */
    public Points(Solution solution) {
        this.solution = TJunctions.close(solution);
        search = new ElementSearch(this.solution);
        faces = new Faces(solution.scene());
        solids = new Solids(new RadiosityBounds(faces.occluders()), faces.fronts());
    }

    /**
     * Reads a file of points as {@link #write} does, to know before a long render whether it can.
     *
     * @throws radiosity.scene.SceneFormatException for a line that is not six numbers
     */
    public static void check(Path in) throws IOException {
        PointList.read(in);
    }

    /**
     * Irradiance and radiosity at a point. Inside a solid no light arrives, though a floor's element may reach there.
     *
     * @param normal of any length but 0; says which side is meant
     */
    public Light at(Vec3 point, Vec3 normal) {
        int element = search.find(point, normal.unit());
        if (element < 0) {
            Rgb none = Rgb.grey(Double.NaN);
            return new Light(none, none);
        }
        if (isInSolid(point, normal.unit())) {
            return new Light(Rgb.BLACK, solution.surface(element).exitance());
        }
        double[] weight = new Nearest(solution, element, point).weights();
        Rgb h = Rgb.BLACK;
        for (int k = 0; k < 3; k++) {
            h = h.plus(solution.irradianceAt(solution.corners()[3 * element + k]).times(weight[k]));
        }
        Vec3 on = Elements.point(solution, element, weight[1], weight[2]);
        return new Light(h, solution.scene().look(solution.faceOf()[element] >> 1, on).radiosity(h));
    }

    private boolean isInSolid(Vec3 point, Vec3 n) {
        Vec3 p = faces.unit(point);
        return solids.hold((float) p.x(), (float) p.y(), (float) p.z(), (float) n.x(), (float) n.y(), (float) n.z());
    }

    /**
     * The light at a point; not a number where no element is.
     *
     * @param irradiance H, W/m²
     * @param radiosity  B, W/m²
     */
    public record Light(Rgb irradiance, Rgb radiosity) {
    }

    /**
     * Reads points (columns x, y, z, nx, ny, nz) and writes them with the light at each, in the same order.
     *
     * @return how many of them lie on no surface; their light is written as nan
     * @throws radiosity.scene.SceneFormatException for a line that is not six numbers
     */
    public int write(Path in, Path out) throws IOException {
        double[] points = PointList.read(in);
        StringBuilder text = new StringBuilder(HEADER);
        int missed = 0;
        for (int i = 0; i < points.length; i += 6) {
            Light light = at(new Vec3(points[i], points[i + 1], points[i + 2]),
                    new Vec3(points[i + 3], points[i + 4], points[i + 5]));
            for (int k = 0; k < 6; k++) {
                text.append(points[i + k]).append(',');
            }
            append(text, light.irradiance()).append(',');
            append(text, light.radiosity()).append('\n');
            missed += Double.isNaN(light.irradiance().r()) ? 1 : 0;
        }
        WholeFile.write(out, text.toString().getBytes(StandardCharsets.US_ASCII));
        return missed;
    }

    private static StringBuilder append(StringBuilder text, Rgb light) {
        return Double.isNaN(light.r()) ? text.append("nan,nan,nan")
                : text.append(light.r()).append(',').append(light.g()).append(',').append(light.b());
    }
}
