package radiosity.scenes;

/**
 * The published spectra of the Cornell box, averaged to three channels.
 *
 * <p>Source: as {@link CornellBox}. Reflectances were measured every 4 nm from 400 to 700 nm. The light's emission is
 * published at 400, 500, 600 and 700 nm, straight lines between; its reflectance was "assumed to be .78".
 *
 * <p>A channel is the plain mean over one third of the measured range (trapezoid rule): blue 400-500 nm, green
 * 500-600 nm, red 600-700 nm. That gives the light (17, 11.8, 4) and white paint (.73, .74, .71). The emission is
 * taken as radiance in W/(m² sr), so the exitance is pi times that.
 */
final class CornellSpectra {

    private static final double[] WHITE = {
        .343, .445, .551, .624, .665, .687, .708, .723, .715, .710, .745, .758, .739, .767, .777, .765, .751, .745,
                .748,
        .729, .745, .757, .753, .750, .746, .747, .735, .732, .739, .734, .725, .721, .733, .725, .732, .743, .744,
                .748,
        .728, .716, .733, .726, .713, .740, .754, .764, .752, .736, .734, .741, .740, .732, .745, .755, .751, .744,
                .731,
        .733, .744, .731, .712, .708, .729, .730, .727, .707, .703, .729, .750, .760, .751, .739, .724, .730, .740,
                .737};

    private static final double[] GREEN = {
        .092, .096, .098, .097, .098, .095, .095, .097, .095, .094, .097, .098, .096, .101, .103, .104, .107, .109,
                .112,
        .115, .125, .140, .160, .187, .229, .285, .343, .390, .435, .464, .472, .476, .481, .462, .447, .441, .426,
                .406,
        .373, .347, .337, .314, .285, .277, .266, .250, .230, .207, .186, .171, .160, .148, .141, .136, .130, .126,
                .123,
        .121, .122, .119, .114, .115, .117, .117, .118, .120, .122, .128, .132, .139, .144, .146, .150, .152, .157,
                .159};

    private static final double[] RED = {
        .040, .046, .048, .053, .049, .050, .053, .055, .057, .056, .059, .057, .061, .061, .060, .062, .062, .062,
                .061,
        .062, .060, .059, .057, .058, .058, .058, .056, .055, .056, .059, .057, .055, .059, .059, .058, .059, .061,
                .061,
        .063, .063, .067, .068, .072, .080, .090, .099, .124, .154, .192, .255, .287, .349, .402, .443, .487, .513,
                .558,
        .584, .620, .606, .609, .651, .612, .610, .650, .638, .627, .620, .630, .628, .642, .639, .657, .639, .635,
                .642};

    /** Radiance of the light at 400, 500, 600 and 700 nm. */
    private static final double[] LIGHT = {0, 8, 15.6, 18.4};

    private CornellSpectra() {
    }

    static Material white() {
        return paint("white", WHITE);
    }

    static Material green() {
        return paint("green", GREEN);
    }

    static Material red() {
        return paint("red", RED);
    }

    static Material light() {
        return Material.lamp("light", Math.PI * third(LIGHT, 2), Math.PI * third(LIGHT, 1), Math.PI * third(LIGHT, 0),
                .78);
    }

    private static Material paint(String name, double[] spectrum) {
        return Material.paint(name, third(spectrum, 2), third(spectrum, 1), third(spectrum, 0));
    }

    /** Mean of a spectrum over the given third of its range, 0 for the shortest waves; samples at equal distances. */
    static double third(double[] spectrum, int which) {
        int steps = (spectrum.length - 1) / 3;
        int first = which * steps;
        double sum = (spectrum[first] + spectrum[first + steps]) / 2;
        for (int k = first + 1; k < first + steps; k++) {
            sum += spectrum[k];
        }
        return sum / steps;
    }
}
