package radiosity.scene;

/**
 * Units of a scene's numbers: of length, where it is known, and of light.
 *
 * <p>Light is radiometric, with three channels in W/m², or photometric: then the channels are linear sRGB in lm/m²
 * and lx, and the luminous quantity is their sum weighted by {@link #WEIGHTS}, so that 1 in each channel makes 1.
 *
 * @param metres        length of a scene unit, m, above 0; NaN where it is not known
 * @param isPhotometric whether light is photometric
 */
public record Units(double metres, boolean isPhotometric) {

    /** Unknown length, radiometric light. */
    public static final Units UNKNOWN = new Units(Double.NaN, false);

    /** Relative luminance of red, green and blue of linear sRGB (IEC 61966-2-1; ITU-R BT.709). */
    public static final Rgb WEIGHTS = new Rgb(0.2126, 0.7152, 0.0722);

    /**
     * Checks the length.
     *
     * @throws IllegalArgumentException where the length is neither NaN nor finite and above 0
     */
    public Units {
        if (!Double.isNaN(metres) && !(metres > 0 && Double.isFinite(metres))) {
            throw new IllegalArgumentException("units: expected a length above 0, got " + metres);
        }
    }

    public boolean isLengthKnown() {
        return !Double.isNaN(metres);
    }

    /** Units of the same length with photometric or radiometric light. */
    public Units withPhotometric(boolean photometric) {
        return new Units(metres, photometric);
    }

    /** Scene units per metre; 1 where the length is not known. */
    public double metre() {
        return isLengthKnown() ? 1 / metres : 1;
    }

    /** Name of the unit of arriving light. */
    public String irradiance() {
        return isPhotometric ? "lx" : "W/m2";
    }

    /** Word for arriving light. */
    public String irradianceWord() {
        return isPhotometric ? "illuminance" : "irradiance";
    }

    /** Name of the unit of leaving light. */
    public String exitance() {
        return isPhotometric ? "lm/m2" : "W/m2";
    }

    /** Name of the unit of {@link #luminance(Rgb)}. */
    public String luminance() {
        return isPhotometric ? "cd/m2" : "W/m2";
    }

    /**
     * How bright a surface looks that leaves this radiosity, in the unit of {@link #luminance()}: the luminance of a
     * diffuse surface, radiosity / pi, where light is photometric, else the weighted radiosity itself.
     *
     * @param radiosity channels in the unit of {@link #exitance}
     */
    public double luminance(Rgb radiosity) {
        return isPhotometric ? weighted(radiosity) / Math.PI : weighted(radiosity);
    }

    /** The unit of {@link #luminance(Rgb)} as a scale names it. */
    public String luminanceScale() {
        return isPhotometric ? luminance() : luminance() + " (Y)";
    }

    /** Factor from weighted radiosity to the unit of {@link #luminance()}. */
    public double luminancePerRadiosity() {
        return isPhotometric ? 1 / Math.PI : 1;
    }

    /** The sum of three channels with {@link #WEIGHTS}, whether light is photometric or not. */
    public static double weighted(Rgb light) {
        return light.r() * WEIGHTS.r() + light.g() * WEIGHTS.g() + light.b() * WEIGHTS.b();
    }

    /** The name of a unit with raised digits, for pictures and windows: W/m² for W/m2. */
    public static String raised(String unit) {
        return unit.replace('2', '\u00b2');
    }

    /** Name of the unit of flux, which is exitance times area times {@link #fluxScale}. */
    public String flux() {
        return isLengthKnown() ? isPhotometric ? "lm" : "W" : exitance() + " x unit2";
    }

    /** Factor from exitance times square scene units to the unit of flux. */
    public double fluxScale() {
        return isLengthKnown() ? metres * metres : 1;
    }

    /** One number for three channels: the luminous quantity, or the mean of radiometric channels. */
    public double total(Rgb light) {
        return isPhotometric ? weighted(light) : (light.r() + light.g() + light.b()) / 3;
    }

    /** Describes the units to the user. */
    @Override
    public String toString() {
        return (isLengthKnown() ? "a scene unit is " + metres + " m" : "length of a scene unit not known") + ", light "
                + (isPhotometric ? "photometric: " : "radiometric: ") + flux() + ", " + irradiance()
                + (isPhotometric ? ", cd/m2" : "");
    }

    /**
     * Flux in the unit of flux, from 1 or 3 channels of exitance times square scene units: the luminous flux, or the
     * mean of radiometric channels, as in {@link #total}.
     */
    public double flux(double... channels) {
        double sum = 0;
        for (int c = 0; c < channels.length; c++) {
            sum += channels[c] * (channels.length < 3 ? 1 : isPhotometric ? WEIGHTS.channel(c) : 1.0 / 3);
        }
        return sum * fluxScale();
    }

    /** A sum over channels in the unit of flux, where it is shared among the channels as {@code like} is. */
    public double fluxLike(double sum, double[] like) {
        double all = 0;
        for (double channel : like) {
            all += channel;
        }
        return all > 0 ? sum / all * flux(like) : sum * fluxScale();
    }
}
