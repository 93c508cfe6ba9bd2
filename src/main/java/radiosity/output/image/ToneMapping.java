package radiosity.output.image;

import java.util.List;
import java.util.Optional;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Srgb;
import radiosity.scene.Units;
import radiosity.solution.Solution;

/**
 * Maps radiosity in W/m² to the linear light of a screen: an exposure, then a curve.
 *
 * @param operator the curve
 * @param exposure factor for radiosity before the curve, above 0
 */
public record ToneMapping(Operator operator, double exposure) {

    /** The curves from exposed radiosity to linear light in [0, 1]. */
    public enum Operator {
        /** The exposed radiosity itself, cut off at 1. */
        LINEAR {
            @Override
            Rgb map(Rgb x) {
                return x;
            }
        },
        /** E. Reinhard and others, Photographic tone reproduction for digital images, 2002, equation 4: keeps hues. */
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

        /** Exposed luminance that Reinhard's curve maps to 1. */
        public static final double WHITE = 4;

        abstract Rgb map(Rgb exposed);

        private static double film(double x) {
            return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
        }
    }

    /** The log-average luminance of a scene after automatic exposure. */
    private static final double MIDDLE = 0.18;
    /** Least luminance that an element counts with in the log-average, as a share of the mean. */
    private static final double DARK = 0.03;

    public ToneMapping {
        if (!(exposure > 0 && exposure <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("exposure: expected a number above 0, got " + exposure);
        }
    }

    /**
     * Chooses the exposure for a solution, brighter by some stops.
     *
     * @param camera what is before the camera is to be neither dark nor pale; empty: all surfaces
     * @param stops  EV, 0 for the automatic exposure itself
     */
    public static ToneMapping automatic(Operator operator, Solution solution, Optional<Camera> camera, double stops) {
        return automatic(operator, LogAverageLuminance.of(solution, camera), stops);
    }

    /** The same for the meshes of a scene file. */
    public static ToneMapping automatic(Operator operator, List<Mesh> meshes, Optional<Camera> camera, double stops) {
        return automatic(operator, LogAverageLuminance.of(meshes, camera), stops);
    }

    private static ToneMapping automatic(Operator operator, LogAverageLuminance brightness, double stops) {
        return new ToneMapping(operator, brightness.exposure(MIDDLE, DARK) * StrictMath.pow(2, stops));
    }

    /** Reinhard's curve, under which walls keep their colour, with automatic exposure of all surfaces. */
    public static ToneMapping automatic(Solution solution) {
        return automatic(Operator.REINHARD, solution, Optional.empty(), 0);
    }

    /** The same with the automatic exposure of what is before a camera. */
    public static ToneMapping automatic(Solution solution, Camera camera) {
        return automatic(Operator.REINHARD, solution, Optional.of(camera), 0);
    }

    /**
     * Maps radiosity to linear light in [0, 1] per channel.
     *
     * @param radiosity W/m²
     */
    public Rgb map(Rgb radiosity) {
        return operator.map(new Rgb(expose(radiosity.r()), expose(radiosity.g()), expose(radiosity.b()))).atMost(1);
    }

    /** Exposes a channel, within [0, 1e6]: light below 0 (of a solution stopped early) becomes black. */
    private double expose(double radiosity) {
        return Math.max(0, Math.min(1e6, radiosity * exposure));
    }

    /** Luminance Y of linear sRGB (IEC 61966-2-1), in the unit of the light. */
    public static double luminance(Rgb light) {
        return Units.weighted(light);
    }

    /** The sRGB code, 0 to 255, of linear light, which is clamped to [0, 1]. */
    public static int srgb(double light) {
        return (int) Math.round(255 * Math.max(0, Math.min(1, Srgb.code(light))));
    }
}
