package radiosity.input.obj;

import radiosity.scene.Rgb;
import radiosity.scene.Surface;

/** A material as a material library describes it. */
final class Material {

    final String name;
    /** Whether a library describes the material. */
    final boolean described;
    /** Kd; null where the library gives none. */
    Rgb diffuse;
    /** Ke; null where the library gives none. */
    Rgb emitted;
    /** map_Kd; null where there is none. */
    TextureImage diffuseImage;
    /** map_Ke; null where there is none. */
    TextureImage emittedImage;
    /** d; NaN where the library gives none. */
    double opacity = Double.NaN;
    /** Tr; NaN where the library gives none. */
    double transparency = Double.NaN;
    boolean hasOpacityImage;

    Material(String name, boolean described) {
        this.name = name;
        this.described = described;
    }

    /** Whether light passes through; Tr counts without d only, as some programs write both as the opacity. */
    boolean isTransparent() {
        return hasOpacityImage || (Double.isNaN(opacity) ? transparency > 0 : opacity < 1);
    }

    /** Kd; without it a light grey, or white under an image. */
    Rgb diffuse() {
        return diffuse != null ? diffuse : Rgb.grey(diffuseImage == null ? Surface.UNKNOWN_REFLECTANCE : 1);
    }

    /** Ke; without it black, or white under an image. */
    Rgb emitted() {
        return emitted != null ? emitted : Rgb.grey(emittedImage == null ? 0 : 1);
    }
}
