package radiosity.scene;

/**
 * Mirroring and transmission of a surface besides its diffuse reflection. Only pictures show them; the radiosity
 * calculation leaves them out.
 *
 * <p>Of the light that arrives at an angle, the surface mirrors {@code R0 + (1 - R0) f} and transmits
 * {@code T (1 - f)}, where f is (F - F0) / (1 - F0), F the reflectance of the refractive index at that angle (A.
 * Fresnel, 1823), and F0 the same reflectance at normal incidence. An index of 1 therefore makes a mirror with the same
 * reflectance at all angles.
 *
 * @param reflectance   R0: mirrored / arriving at normal incidence, each channel in [0, 1]
 * @param transmittance T: transmitted / arriving at normal incidence, each channel in [0, 1 - R0]
 * @param diffuse       share of the diffusely reflected light that is seen at normal incidence, in [0, 1]; at an angle
 *                      multiplied by 1 - f
 * @param roughness     0 smooth to 1, as in glTF: the square root of the width of the microfacets' slopes
 * @param index         refractive index behind the surface / that in front of it, in [{@value #LEAST_INDEX},
 *                      {@value #MOST_INDEX}]
 * @param thin          whether the surface is a sheet with the same medium on both sides: light is not refracted
 */
public record Specular(Rgb reflectance, Rgb transmittance, double diffuse, double roughness, double index,
        boolean thin) {

    public static final double LEAST_INDEX = 0.1;
    public static final double MOST_INDEX = 10;
    /** Amount by which R0 + T may be above 1 by rounding. */
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

    /** F0: reflectance of a refractive index at normal incidence, the same from either side. */
    public static double normalReflectance(double index) {
        double root = (index - 1) / (index + 1);
        return root * root;
    }

    public boolean transmits() {
        return transmittance.max() > 0;
    }
}
