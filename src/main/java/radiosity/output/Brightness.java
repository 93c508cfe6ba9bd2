package radiosity.output;

import radiosity.scene.Rgb;
import radiosity.world.Solution;

/** How bright the surfaces are that reflect: lamps are left out, they would make everything else black. */
final class Brightness {

    private final Solution solution;
    private double area;
    private double sum;
    private double brightest;

    Brightness(Solution solution) {
        this.solution = solution;
        for (int e = 0; e < solution.elements(); e++) {
            double l = luminance(e);
            brightest = Math.max(brightest, l);
            if (!solution.surface(e).emits()) {
                area += area(e);
                sum += area(e) * l;
            }
        }
    }

    private double area(int element) {
        return 0.5 * Elements.cross(solution, element).length();
    }

    /** Mean over the corners, W/m²; at least 0. */
    private double luminance(int element) {
        double l = 0;
        for (int k = 0; k < 3; k++) {
            Rgb b = solution.radiosityAt(element, k);
            l += Math.max(0, ToneMapping.luminance(b)) / 3;
        }
        return l;
    }

    /**
     * What radiosity must be multiplied with. Where only lamps shine, the brightest becomes 1; without light 1.
     *
     * @param middle the exposed log-average
     * @param dark   the least luminance that counts, of the mean
     */
    double exposure(double middle, double dark) {
        if (!(sum > 0)) {
            return brightest > 0 ? 1 / brightest : 1;
        }
        double logs = 0;
        for (int e = 0; e < solution.elements(); e++) {
            if (!solution.surface(e).emits()) {
                logs += area(e) * StrictMath.log(Math.max(luminance(e) * area / sum, dark));
            }
        }
        return middle * area / sum / StrictMath.exp(logs / area);
    }
}
