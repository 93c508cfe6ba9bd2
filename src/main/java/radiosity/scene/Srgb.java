package radiosity.scene;

import java.util.stream.IntStream;

/** The transfer function of sRGB (IEC 61966-2-1), used for images and screens; its formula also holds above 1. */
public final class Srgb {

    /** Linear light of the codes of 8 bits, which most images have. */
    private static final double[] LINEAR = IntStream.range(0, 256).mapToDouble(k -> power(k / 255.0)).toArray();

    private Srgb() { }

    /** Linear light of a code, both 1 at white; by StrictMath, as the result enters the calculation. */
    public static double linear(double code) {
        int k = (int) Math.rint(255 * code);
        return k >= 0 && k <= 255 && k / 255.0 == code ? LINEAR[k] : power(code);
    }

    private static double power(double code) {
        return code <= 0.04045 ? code / 12.92 : StrictMath.pow((code + 0.055) / 1.055, 2.4);
    }

    /** Linear light of three codes, all 1 at white. */
    public static Rgb linear(Rgb code) {
        return new Rgb(linear(code.r()), linear(code.g()), linear(code.b()));
    }

    /** The code of linear light, both 1 at white; for display only. */
    public static double code(double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * StrictMath.pow(linear, 1 / 2.4) - 0.055;
    }
}
