package radiosity.scene;

/**
 * In which units a scene's numbers are: of length, where that is known, and of light.
 *
 * <p>Light is radiometric, with three channels in W/m², or photometric: then the channels are those of linear sRGB in
 * lm/m² and lx, and the luminous quantity is their sum weighted by {@link #WEIGHTS}, of which 1 of each channel is 1.
 *
 * @param metres        length of a scene unit, m; not a number where it is not known
 * @param isPhotometric whether the numbers of light are
 */
public record Units(double metres, boolean isPhotometric) {

    /** Nothing is known of the length, and light is radiometric. */
    public static final Units UNKNOWN = new Units(Double.NaN, false);

    /** Luminance of red, green and blue of linear sRGB (IEC 61966-2-1; ITU-R BT.709). */
    public static final Rgb WEIGHTS = new Rgb(0.2126, 0.7152, 0.0722);

    /**
     * Checks itself.
     *
     * @throws IllegalArgumentException where a unit is no finite length above 0
     */
    public Units {
        if (!Double.isNaN(metres) && !(metres > 0 && Double.isFinite(metres))) {
            throw new IllegalArgumentException("units: expected a length above 0, got " + metres);
        }
    }

    /** Whether the length of a scene unit is known. */
    public boolean isLengthKnown() {
        return !Double.isNaN(metres);
    }

    /** The same with light of this kind. */
    public Units withPhotometric(boolean photometric) {
        return new Units(metres, photometric);
    }

    /** Scene units per metre; 1 where that is not known. */
    public double metre() {
        return isLengthKnown() ? 1 / metres : 1;
    }

    /** Of what arrives. */
    public String irradiance() {
        return isPhotometric ? "lx" : "W/m2";
    }

    /** Of what leaves. */
    public String exitance() {
        return isPhotometric ? "lm/m2" : "W/m2";
    }

    /** Of flux, which is exitance times an area of {@link #fluxScale}. */
    public String flux() {
        return isLengthKnown() ? isPhotometric ? "lm" : "W" : exitance() + " x unit2";
    }

    /** What 1 of exitance times square scene unit is of the unit of flux. */
    public double fluxScale() {
        return isLengthKnown() ? metres * metres : 1;
    }

    /** One number for three channels: the luminous quantity, or the mean of radiometric channels. */
    public double total(Rgb light) {
        return isPhotometric ? light.r() * WEIGHTS.r() + light.g() * WEIGHTS.g() + light.b() * WEIGHTS.b()
                : (light.r() + light.g() + light.b()) / 3;
    }

    /** One number for the flux of 1 or 3 channels: the luminous flux, or the sum of radiometric channels. */
    public double flux(double... channels) {
        double sum = 0;
        for (int c = 0; c < channels.length; c++) {
            sum += channels[c] * (isPhotometric && channels.length == 3 ? WEIGHTS.channel(c) : 1);
        }
        return sum * fluxScale();
    }
}
