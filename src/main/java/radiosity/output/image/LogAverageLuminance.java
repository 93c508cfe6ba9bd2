package radiosity.output.image;

import java.util.List;
import java.util.Optional;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/**
 * The log-average luminance of surfaces that do not emit: with lamps, an exposure would make everything else black.
 * Elements without any light are left out, such as the outer sides of walls: with these, rooms whose walls have a
 * thickness would be shown too bright.
 *
 * <p>The average is over all surfaces, or over the solid angles of those before a camera, so that a room is not black
 * for the sunlit ground around the house. Nothing is found out of what hides what: all that stands before the camera
 * fills the picture once, and hidden surfaces are farther away.
 */
final class LogAverageLuminance {

    /** Largest solid angle of an element, sr: those close to the eye have less than their middle tells. */
    private static final double MOST = 0.5;

    /** 1 per element that counts: its area, square scene units, or its solid angle, sr. */
    private final double[] weight;
    /** 1 per element that counts: mean over its corners, W/m², above 0. */
    private final double[] luminance;
    private int counted;
    private double weights;
    private double sum;
    private double brightest;

    private LogAverageLuminance(int elements) {
        weight = new double[elements];
        luminance = new double[elements];
    }

    /** @param camera empty: all surfaces count, by their areas; these count, too, where the camera sees nothing */
    static LogAverageLuminance of(Solution solution, Optional<Camera> camera) {
        LogAverageLuminance brightness = new LogAverageLuminance(solution.elements());
        for (int e = 0; e < solution.elements(); e++) {
            brightness.add(weight(camera, Elements.corner(solution, e, 0), Elements.corner(solution, e, 1),
                    Elements.corner(solution, e, 2)), solution.surface(e).emits(),
                    solution.radiosityAt(e, 0), solution.radiosityAt(e, 1), solution.radiosityAt(e, 2));
        }
        return brightness.sum > 0 || camera.isEmpty() ? brightness : of(solution, Optional.empty());
    }

    static LogAverageLuminance of(List<Mesh> meshes, Optional<Camera> camera) {
        LogAverageLuminance brightness = new LogAverageLuminance(meshes.stream().mapToInt(Mesh::elements).sum());
        for (Mesh mesh : meshes) {
            for (int e = 0; e < mesh.elements(); e++) {
                brightness.add(weight(camera, mesh.position(e, 0), mesh.position(e, 1), mesh.position(e, 2)),
                        mesh.surface().emits(), mesh.radiosity(e, 0), mesh.radiosity(e, 1), mesh.radiosity(e, 2));
            }
        }
        return brightness.sum > 0 || camera.isEmpty() ? brightness : of(meshes, Optional.empty());
    }

    /** Area of a triangle, or its solid angle in a camera's picture, about; 0 where its middle is outside of that. */
    private static double weight(Optional<Camera> camera, Vec3 a, Vec3 b, Vec3 c) {
        Vec3 half = b.minus(a).cross(c.minus(a)).times(0.5);
        if (camera.isEmpty()) {
            return half.length();
        }
        Vec3 to = a.plus(b).plus(c).times(1. / 3).minus(camera.get().position());
        double distance = to.length();
        boolean isSeen = distance > 0 && camera.get().frames(to);
        return isSeen ? Math.max(0, Math.min(MOST, -half.dot(to) / (distance * distance * distance))) : 0;
    }

    /** @param radiosity at the element's corners, W/m² */
    private void add(double itsWeight, boolean emits, Rgb... radiosity) {
        double l = 0;
        for (Rgb b : radiosity) {
            l += Math.max(0, ToneMapping.luminance(b)) / 3;
        }
        brightest = Math.max(brightest, l);
        if (!emits && l > 0 && itsWeight > 0) {
            weight[counted] = itsWeight;
            luminance[counted++] = l;
            weights += itsWeight;
            sum += itsWeight * l;
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
            logs += weight[i] * StrictMath.log(Math.max(luminance[i] * weights / sum, dark));
        }
        return middle * weights / sum / StrictMath.exp(logs / weights);
    }
}
