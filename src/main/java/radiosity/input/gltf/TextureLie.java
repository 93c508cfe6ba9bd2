package radiosity.input.gltf;

/**
 * How an image lies on a surface: a set of texture coordinates, and their map to (u, v) with v upwards
 * (KHR_texture_transform).
 *
 * @param set which coordinates
 * @param uu  factor of u for u
 * @param uv  factor of v for u
 * @param u   added to u
 * @param vu  factor of u for v
 * @param vv  factor of v for v
 * @param v   added to v
 */
record TextureLie(int set, double uu, double uv, double u, double vu, double vv, double v) {

    /** Of coordinates scaled, turned counter-clockwise as one sees the image, and moved; v downwards. */
    static TextureLie of(int set, double[] scale, double rotation, double[] offset) {
        double c = StrictMath.cos(rotation);
        double s = StrictMath.sin(rotation);
        return new TextureLie(set, c * scale[0], s * scale[1], offset[0], s * scale[0], -c * scale[1],
                1 - offset[1]);
    }

    float u(float givenU, float givenV) {
        return (float) (uu * givenU + uv * givenV + u);
    }

    float v(float givenU, float givenV) {
        return (float) (vu * givenU + vv * givenV + v);
    }
}
