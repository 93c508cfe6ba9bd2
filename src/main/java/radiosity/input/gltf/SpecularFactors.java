package radiosity.input.gltf;

import java.util.Optional;
import radiosity.gltf.JsonCursor;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Specular;

/** Mirroring of a material: metallic-roughness, KHR_materials_transmission, KHR_materials_ior, KHR_materials_volume. */
final class SpecularFactors {

    /** From this roughness on, an opaque surface is shown as diffuse. */
    private static final double ROUGH = 0.5;
    private static final double USUAL_INDEX = 1.5;

    private SpecularFactors() { }

    /**
     * Mirroring and transmission by a material's factors; empty where images vary them or pictures show none.
     *
     * @param colour   the base colour
     * @param hasImage whether an image varies the base colour
     */
    static Optional<Specular> of(JsonCursor material, Rgb colour, boolean hasImage) throws SceneFormatException {
        Optional<JsonCursor> base = material.optional("pbrMetallicRoughness");
        boolean isVaried = base.isPresent() && base.get().optional("metallicRoughnessTexture").isPresent();
        double metallic = base.isEmpty() ? 1 : share(base.get().number("metallicFactor", 1));
        double roughness = base.isEmpty() ? 1 : share(base.get().number("roughnessFactor", 1));
        Optional<JsonCursor> glass = material.extension("KHR_materials_transmission");
        double passed = glass.isEmpty() || glass.get().optional("transmissionTexture").isPresent() ? 0
                : share(glass.get().number("transmissionFactor", 0));
        double index = index(material);
        if (isVaried || hasImage && metallic > 0 || roughness >= ROUGH && passed * (1 - metallic) == 0
                || material.extension("KHR_materials_unlit").isPresent()
                || material.extension("KHR_materials_pbrSpecularGlossiness").isPresent()) {
            return Optional.empty();
        }
        Rgb tint = colour.atMost(1);
        double normal = Specular.normalReflectance(index);
        double rest = (1 - metallic) * (1 - normal);
        Optional<JsonCursor> volume = material.extension("KHR_materials_volume");
        boolean isThin = volume.isEmpty() || !(volume.get().number("thicknessFactor", 0) > 0);
        return Optional.of(new Specular(tint.times(metallic).plus(Rgb.grey((1 - metallic) * normal)),
                tint.times(rest * passed), rest * (1 - passed), roughness, index, isThin));
    }

    /** The refractive index within the range of {@link Specular}; 0 stands for infinity. */
    private static double index(JsonCursor material) throws SceneFormatException {
        Optional<JsonCursor> extension = material.extension("KHR_materials_ior");
        double index = extension.isEmpty() ? USUAL_INDEX : extension.get().number("ior", USUAL_INDEX);
        if (!(index == 0 || index >= 1)) {
            throw extension.get().at("ior").wrong("an index of refraction of at least 1, or 0");
        }
        return index == 0 ? Specular.MOST_INDEX : Math.min(Specular.MOST_INDEX, index);
    }

    private static double share(double value) {
        return Math.max(0, Math.min(1, value));
    }
}
