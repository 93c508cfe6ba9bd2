package radiosity.viewer;

import radiosity.output.image.ToneMapping;
import radiosity.scene.Units;

/** Logarithmic colour scale of luminance: the colour map of light.frag in Java, for the scale beside the picture. */
final class TurboColourMap {

    /** Decades of luminance from blue to red. */
    static final int DECADES = 3;

    private static final double[][] TURBO = {
        {0.13572138, 4.61539260, -42.66032258, 132.13108234, -152.94239396, 59.28637943},
        {0.09140261, 2.19418839, 4.84296658, -14.18503333, 4.27729857, 2.82956604},
        {0.10667330, 12.64194608, -60.58204836, 110.36276771, -89.90310912, 27.34824973}};

    private TurboColourMap() { }

    /** Luminance shown as red, W/m² or cd/m²; inversely proportional to the exposure. */
    static double top(ToneMapping toneMapping, Units units) {
        return ToneMapping.Operator.WHITE / toneMapping.exposure() * units.luminancePerRadiosity();
    }

    /**
     * Returns the colour of a value (A. Mikhailov, Turbo, an improved rainbow colormap, 2019: its published
     * polynomial).
     *
     * @param x in [0, 1]
     * @return 0xRRGGBB
     */
    static int turbo(double x) {
        int rgb = 0;
        for (double[] polynomial : TURBO) {
            double y = 0;
            for (int i = polynomial.length - 1; i >= 0; i--) {
                y = y * x + polynomial[i];
            }
            rgb = rgb << 8 | (int) Math.round(255 * Math.max(0, Math.min(1, y)));
        }
        return rgb;
    }
}
