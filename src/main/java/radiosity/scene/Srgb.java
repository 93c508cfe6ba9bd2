package radiosity.scene;

/** What images and screens call light: sRGB, IEC 61966-2-1; values above 1 are continued. */
public final class Srgb {

    private Srgb() { }

    /** Linear light of a code, where 1 is white; the same on every machine, as it is calculated with. */
    public static double linear(double code) {
        return code <= 0.04045 ? code / 12.92 : StrictMath.pow((code + 0.055) / 1.055, 2.4);
    }

    /** Linear light of three codes, where 1 is white. */
    public static Rgb linear(Rgb code) {
        return new Rgb(linear(code.r()), linear(code.g()), linear(code.b()));
    }

    /** The code of linear light, where 1 is white; to look at. */
    public static double code(double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * StrictMath.pow(linear, 1 / 2.4) - 0.055;
    }
}
