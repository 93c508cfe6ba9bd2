package radiosity.input.obj;

import radiosity.scene.Rgb;

/** What a material library says of a material, as written. */
final class Material {

    /** Reflectance where nothing is said: a light grey. */
    private static final double GREY = 0.8;

    final String name;
    /** Whether a library describes it. */
    final boolean described;
    /** Kd; null where it is not said. */
    Rgb diffuse;
    /** Ke; null where it is not said. */
    Rgb emitted;
    /** map_Kd; null where there is none. */
    TextureImage diffuseImage;
    /** map_Ke; null where there is none. */
    TextureImage emittedImage;
    boolean transparent;

    Material(String name, boolean described) {
        this.name = name;
        this.described = described;
    }

    /** Kd: a light grey, or white under an image, where it is not said. */
    Rgb diffuse() {
        return diffuse != null ? diffuse : Rgb.grey(diffuseImage == null ? GREY : 1);
    }

    /** Ke: nothing, or all of an image, where it is not said. */
    Rgb emitted() {
        return emitted != null ? emitted : Rgb.grey(emittedImage == null ? 0 : 1);
    }
}
