package radiosity.output.image;

import java.util.List;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Rgb;
import radiosity.solution.Solution;

/**
 * The log-average luminance of surfaces that do not emit: with lamps, an exposure would make everything else black.
 * Elements without any light are left out, such as the outer sides of walls: with these, rooms whose walls have a
 * thickness would be shown too bright.
 */
final class LogAverageLuminance {

    /** 1 per element that counts, square scene units. */
    private final double[] area;
    /** 1 per element that counts: mean over its corners, W/m², above 0. */
    private final double[] luminance;
    private int counted;
    private double areas;
    private double sum;
    private double brightest;

    private LogAverageLuminance(int elements) {
        area = new double[elements];
        luminance = new double[elements];
    }

    static LogAverageLuminance of(Solution solution) {
        LogAverageLuminance brightness = new LogAverageLuminance(solution.elements());
        for (int e = 0; e < solution.elements(); e++) {
            brightness.add(0.5 * Elements.cross(solution, e).length(), solution.surface(e).emits(),
                    solution.radiosityAt(e, 0), solution.radiosityAt(e, 1), solution.radiosityAt(e, 2));
        }
        return brightness;
    }

    static LogAverageLuminance of(List<Mesh> meshes) {
        LogAverageLuminance brightness = new LogAverageLuminance(meshes.stream().mapToInt(Mesh::elements).sum());
        for (Mesh mesh : meshes) {
            for (int e = 0; e < mesh.elements(); e++) {
                brightness.add(0.5 * mesh.cross(e).length(), mesh.surface().emits(), mesh.radiosity(e, 0),
                        mesh.radiosity(e, 1), mesh.radiosity(e, 2));
            }
        }
        return brightness;
    }

    /** @param radiosity at the element's corners, W/m² */
    private void add(double itsArea, boolean emits, Rgb... radiosity) {
        double l = 0;
        for (Rgb b : radiosity) {
            l += Math.max(0, ToneMapping.luminance(b)) / 3;
        }
        brightest = Math.max(brightest, l);
        if (!emits && l > 0) {
            area[counted] = itsArea;
            luminance[counted++] = l;
            areas += itsArea;
            sum += itsArea * l;
        }
    }

    /**
     * The factor for radiosity that brings the log-average luminance to a value. If only lamps give light, the
     * brightest element becomes 1; without any light the factor is 1.
     *
     * @param middle log-average after multiplication
     * @param dark   least luminance that an element counts with, as a share of the mean
     */
    double exposure(double middle, double dark) {
        if (!(sum > 0)) {
            return brightest > 0 ? 1 / brightest : 1;
        }
        double logs = 0;
        for (int i = 0; i < counted; i++) {
            logs += area[i] * StrictMath.log(Math.max(luminance[i] * areas / sum, dark));
        }
        return middle * areas / sum / StrictMath.exp(logs / areas);
    }
}
