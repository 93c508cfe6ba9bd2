package radiosity.output.grid;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import radiosity.scene.Lamp;
import radiosity.scene.Light;
import radiosity.scene.Scene;

/**
 * Daylight factors of a grid: illuminance, in percent of that of a level place in the open under the same overcast sky
 * (CIE S 017, 2020, 17-29-121), with the median and the value over 95 % of the area that EN 17037 (2018) asks for.
 *
 * @param outdoors illuminance of a level place in the open, in the unit of the grid, above 0
 * @param average  mean over the area for which the points stand, percent
 * @param median   factor that half of the area exceeds, percent
 * @param exceeded factor that 95 % of the area exceeds, percent
 */
public record DaylightFactor(double outdoors, double average, double median, double exceeded) {

    /**
     * The daylight factors of points.
     *
     * @param rising illuminance of each point, ascending
     * @param areas  for which the points stand
     * @param mean   illuminance, average over these areas
     * @return empty where the scene's light comes from anything but one overcast sky, or there is no point
     */
    static Optional<DaylightFactor> of(Scene scene, double[] rising, double[] areas, double mean) {
        List<Lamp> lamps = scene.lamps();
        if (rising.length == 0 || lamps.size() != 1 || scene.lights().size() != 1
                || scene.lights().get(0).kind() != Light.Kind.SKY_OVERCAST) {
            return Optional.empty();
        }
        double outdoors = scene.units().total(scene.lights().get(0).power());
        double area = Arrays.stream(areas).sum();
        return Optional.of(new DaylightFactor(outdoors, 100 * mean / outdoors,
                100 * below(rising, areas, 0.5 * area) / outdoors, 100 * below(rising, areas, 0.05 * area) / outdoors));
    }

    /** The least illuminance of a point such that the points up to it stand for more than an area. */
    private static double below(double[] rising, double[] areas, double area) {
        double sum = 0;
        for (int i = 0; i < rising.length; i++) {
            sum += areas[i];
            if (sum > area) {
                return rising[i];
            }
        }
        return rising[rising.length - 1];
    }

    /** The daylight factor where an illuminance arrives, percent. */
    double percent(double illuminance) {
        return 100 * illuminance / outdoors;
    }

    /** The figures in one line of text. */
    String summary() {
        return String.format(Locale.ROOT, "daylight factor average %.2f %%, median %.2f, over 95 %% of the area at"
                + " least %.2f", average, median, exceeded);
    }
}
