package radiosity.input.gltf;

/**
 * The mapping of an image onto a surface: a set of texture coordinates, and their affine map to (u, v) with v upwards
 * (KHR_texture_transform).
 *
 * @param set index of the set of texture coordinates
 * @param uu  factor of the given u in u
 * @param uv  factor of the given v in u
 * @param u   added to u
 * @param vu  factor of the given u in v
 * @param vv  factor of the given v in v
 * @param v   added to v
 */
record TextureLie(int set, double uu, double uv, double u, double vu, double vv, double v) {

    /** The mapping that scales, rotates counter-clockwise in the image and moves coordinates (v downwards). */
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
