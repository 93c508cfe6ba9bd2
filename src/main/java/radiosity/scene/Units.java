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

    /** Name of the unit of leaving light. */
    public String exitance() {
        return isPhotometric ? "lm/m2" : "W/m2";
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
        return isPhotometric ? light.r() * WEIGHTS.r() + light.g() * WEIGHTS.g() + light.b() * WEIGHTS.b()
                : (light.r() + light.g() + light.b()) / 3;
    }

    /** Flux in the unit of flux, from 1 or 3 channels of exitance times square scene units: luminous, or summed. */
    public double flux(double... channels) {
        double sum = 0;
        for (int c = 0; c < channels.length; c++) {
            sum += channels[c] * (isPhotometric && channels.length == 3 ? WEIGHTS.channel(c) : 1);
        }
        return sum * fluxScale();
    }
}
