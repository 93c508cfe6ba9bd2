package radiosity.output.image;

import java.util.List;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Rgb;
import radiosity.scene.Srgb;
import radiosity.scene.Units;
import radiosity.solution.Solution;

/**
 * From radiosity in W/m² to what a screen shows: an exposure, then a curve.
 *
 * @param operator the curve
 * @param exposure what radiosity is multiplied with before, above 0
 */
public record ToneMapping(Operator operator, double exposure) {

    /** The curves from exposed radiosity to linear light in [0, 1]. */
    public enum Operator {
        /** Straight, then white. */
        LINEAR {
            @Override
            Rgb map(Rgb x) {
                return x;
            }
        },
        /**
         * E. Reinhard and others, Photographic tone reproduction for digital images, 2002, equation 4: keeps hues.
         */
        REINHARD {
            @Override
            Rgb map(Rgb x) {
                double l = luminance(x);
                return x.times((1 + l / (WHITE * WHITE)) / (1 + l));
            }
        },
        /** K. Narkowicz, ACES filmic tone mapping curve, 2015: more contrast, lamps pale. */
        FILMIC {
            @Override
            Rgb map(Rgb x) {
                return new Rgb(film(x.r()), film(x.g()), film(x.b()));
            }
        };

        /** The exposed luminance that becomes white. */
        public static final double WHITE = 4;

        abstract Rgb map(Rgb exposed);

        private static double film(double x) {
            return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
        }
    }

    /** The exposure brings the scene's log-average luminance here. */
    private static final double MIDDLE = 0.18;
    /** Darker than this, of the mean, counts as this in the log-average. */
    private static final double DARK = 0.03;

    public ToneMapping {
        if (!(exposure > 0 && exposure <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("exposure: expected a number above 0, got " + exposure);
        }
    }

    /**
     * The automatic choice for a solution, made brighter by some stops.
     *
     * @param stops EV, 0 for the choice itself
     */
    public static ToneMapping automatic(Operator operator, Solution solution, double stops) {
        return automatic(operator, LogAverageLuminance.of(solution), stops);
    }

    /** The automatic choice for what a scene file holds, made brighter by some stops. */
    public static ToneMapping automatic(Operator operator, List<Mesh> meshes, double stops) {
        return automatic(operator, LogAverageLuminance.of(meshes), stops);
    }

    private static ToneMapping automatic(Operator operator, LogAverageLuminance brightness, double stops) {
        return new ToneMapping(operator, brightness.exposure(MIDDLE, DARK) * StrictMath.pow(2, stops));
    }

    /** Reinhard's curve, automatic exposure: walls keep their colour. */
    public static ToneMapping automatic(Solution solution) {
        return automatic(Operator.REINHARD, solution, 0);
    }

    /**
     * Linear light in [0, 1] per channel.
     *
     * @param radiosity W/m²
     */
    public Rgb map(Rgb radiosity) {
        return operator.map(new Rgb(expose(radiosity.r()), expose(radiosity.g()), expose(radiosity.b()))).atMost(1);
    }

    /** Light below 0 (of a solution stopped early) is none; far above white all is the same. */
    private double expose(double radiosity) {
        return Math.max(0, Math.min(1e6, radiosity * exposure));
    }

    /** Y of linear sRGB (IEC 61966-2-1). */
    public static double luminance(Rgb light) {
        return light.r() * Units.WEIGHTS.r() + light.g() * Units.WEIGHTS.g() + light.b() * Units.WEIGHTS.b();
    }

    /** The sRGB code, 0 to 255, of linear light in [0, 1]. */
    public static int srgb(double light) {
        return (int) Math.round(255 * Math.max(0, Math.min(1, Srgb.code(light))));
    }
}
