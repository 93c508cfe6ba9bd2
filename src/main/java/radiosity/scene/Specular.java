package radiosity.scene;

/**
 * What a surface does besides emitting and reflecting diffusely: it mirrors, and lets light through. Only pictures show
 * that; the calculation of light leaves it out.
 *
 * <p>Of what falls on it at an angle, it mirrors {@code R0 + (1 - R0) f} and lets {@code T (1 - f)} through, where f is
 * (F - F0) / (1 - F0), F what the refractive index makes the surface reflect at that angle (A. Fresnel, 1823), and F0
 * the same at right angles. So an index of 1 makes a mirror that is the same at all angles.
 *
 * @param reflectance   R0: mirrored / arriving at right angles, each channel in [0, 1]
 * @param transmittance T: what goes through / arriving at right angles, each channel in [0, 1 - R0]
 * @param diffuse       share of what is reflected diffusely that is seen at right angles, in [0, 1]; times 1 - f
 * @param roughness     0 smooth to 1, as glTF has it: the square root of the width of the microfacets' slopes
 * @param index         refractive index of what is behind the surface, over that of what is in front, in
 *                      [{@value #LEAST_INDEX}, {@value #MOST_INDEX}]
 * @param thin          whether it is a sheet, behind which there is at once the same as in front: nothing is refracted
 */
public record Specular(Rgb reflectance, Rgb transmittance, double diffuse, double roughness, double index,
        boolean thin) {

    public static final double LEAST_INDEX = 0.1;
    public static final double MOST_INDEX = 10;
    /** How far the sum of shares may be above 1 by rounding. */
    private static final double ROUNDING = 1e-6;

    public Specular {
        for (int c = 0; c < 3; c++) {
            require("reflectance", reflectance.channel(c), 0, 1);
            require("transmittance", transmittance.channel(c), 0, 1 - reflectance.channel(c) + ROUNDING);
        }
        require("diffuse", diffuse, 0, 1);
        require("roughness", roughness, 0, 1);
        require("refractive index", index, LEAST_INDEX, MOST_INDEX);
    }

    private static void require(String what, double value, double least, double most) {
        if (!(value >= least && value <= most)) {
            throw new IllegalArgumentException(what + ": expected a number from " + least + " to " + most + ", got "
                    + value);
        }
    }

    /** F0: what a refractive index makes a surface reflect at right angles, from either side. */
    public static double normalReflectance(double index) {
        double root = (index - 1) / (index + 1);
        return root * root;
    }

    public boolean transmits() {
        return transmittance.max() > 0;
    }
}
