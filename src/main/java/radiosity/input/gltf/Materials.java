package radiosity.input.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import radiosity.gltf.GltfLists;
import radiosity.gltf.JsonCursor;
import radiosity.input.file.Diagnostics;
import radiosity.scene.ImageMap;
import radiosity.scene.ImageSource;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Specular;
import radiosity.scene.Surface;

/** The surfaces of a scene, one per material in use: base colour becomes reflectance, emission becomes exitance. */
final class Materials {

    private final JsonCursor root;
    private final Buffers buffers;
    private final double perEmission;
    private final Diagnostics notes;
    private final List<Surface> surfaces = new ArrayList<>();
    private final List<Optional<TextureLie>> lies = new ArrayList<>();
    /** 1 entry per surface: see {@link #excess}. */
    private final List<Rgb> excesses = new ArrayList<>();
    private final Set<Integer> clipped = new HashSet<>();
    /** The surfaces of materials, in the order of the surfaces. */
    private final Map<Integer, Integer> known = new LinkedHashMap<>();
    private final Set<String> names = new HashSet<>();
    private final Map<Integer, Optional<ImageSource>> images = new HashMap<>();

    /**
     * @param photometric whether emission is a luminance in cd/m²; the exitance in lm/m² is then pi times as large
     */
    Materials(JsonCursor root, Buffers buffers, boolean photometric, Diagnostics notes) {
        perEmission = photometric ? Math.PI : 1;
        this.root = root;
        this.buffers = buffers;
        this.notes = notes;
    }

    List<Surface> surfaces() {
        return surfaces;
    }

    /** Index in the file of the material of each surface; -1 for glTF's default material. */
    List<Integer> numbers() {
        return List.copyOf(known.keySet());
    }

    /** The mapping of a surface's images onto its triangles; empty where the surface has no image. */
    Optional<TextureLie> lie(int surface) {
        return lies.get(surface);
    }

    /** Whether an image gives the reflectance of a surface. */
    boolean hasImage(int surface) {
        return hasImage(surfaces.get(surface).textures(), ImageMap.Target.REFLECTANCE);
    }

    /** Base colour of a surface / its reflectance, per channel; above 1 where the reflectance was clipped, else 1. */
    Rgb excess(int surface) {
        return excesses.get(surface);
    }

    /** Notes, once per surface, that its reflectance was clipped. */
    void tellClipped(int surface) {
        if (clipped.add(surface)) {
            notes.note("", "reflectances of 1 and more are taken as " + Surface.MAX_REFLECTANCE,
                    surfaces.get(surface).name());
        }
    }

    /** Index of the surface of a material; material -1 is glTF's default material. */
    int surface(int material) throws IOException {
        Integer number = known.get(material);
        if (number == null) {
            number = surfaces.size();
            add(material);
            known.put(material, number);
        }
        return number;
    }

    private void add(int number) throws IOException {
        if (number < 0) {
            surfaces.add(new Surface(unique("default"), Rgb.BLACK, limited(Rgb.grey(1)), false));
            lies.add(Optional.empty());
            return;
        }
        JsonCursor material = root.at("materials").at(number);
        String name = unique(material.text("name", "material " + number));
        Optional<JsonCursor> old = material.extension("KHR_materials_pbrSpecularGlossiness");
        Optional<JsonCursor> base = old.isPresent() ? old : material.optional("pbrMetallicRoughness");
        Rgb colour = Rgb.grey(1);
        Optional<JsonCursor> baseTexture = Optional.empty();
        if (base.isPresent()) {
            double[] factor = base.get().numbers(old.isPresent() ? "diffuseFactor" : "baseColorFactor", 1, 1, 1, 1);
            colour = new Rgb(Math.max(0, factor[0]), Math.max(0, factor[1]), Math.max(0, factor[2]));
            baseTexture = base.get().optional(old.isPresent() ? "diffuseTexture" : "baseColorTexture");
        }
        double[] e = material.numbers("emissiveFactor", 0, 0, 0);
        Optional<JsonCursor> more = material.extension("KHR_materials_emissive_strength");
        double strength = more.isPresent() ? more.get().number("emissiveStrength", 1) : 1;
        Rgb exitance = new Rgb(e[0], e[1], e[2]).times(strength * perEmission);
        if (!exitance.isFinite() || Math.min(exitance.r(), Math.min(exitance.g(), exitance.b())) < 0) {
            throw material.wrong("emission of at least 0");
        }
        if (!material.text("alphaMode", "OPAQUE").equals("OPAQUE")) {
            notes.note("", "transparent surfaces are taken as opaque (see --leave-out)", name);
        }
        List<ImageMap> maps = new ArrayList<>(0);
        Optional<TextureLie> lie = Optional.empty();
        if (baseTexture.isPresent()) {
            lie = addImage(maps, ImageMap.Target.REFLECTANCE, baseTexture.get(), colour, lie);
        }
        Optional<JsonCursor> emitted = material.optional("emissiveTexture");
        if (emitted.isPresent() && exitance.max() > 0) {
            lie = addImage(maps, ImageMap.Target.EXITANCE, emitted.get(), exitance, lie);
            if (!hasImage(maps, ImageMap.Target.EXITANCE)) {
                notes.note("", "surfaces whose image of emission is left out do not emit", name);
                exitance = Rgb.BLACK;
            }
        }
        lies.add(lie);
        if (baseTexture.isPresent() && !hasImage(maps, ImageMap.Target.REFLECTANCE)) {
            colour = Surface.withoutImage(colour);
        }
        Optional<Specular> specular = SpecularFactors.of(material, colour, hasImage(maps, ImageMap.Target.REFLECTANCE));
        if (specular.isPresent() && specular.get().transmits()) {
            notes.note("", "transparent surfaces let no light through; pictures show what is behind them", name);
        }
        surfaces.add(new Surface(name, exitance, limited(colour), material.isOn("doubleSided"), maps).with(specular));
    }

    private static boolean hasImage(List<ImageMap> maps, ImageMap.Target target) {
        return maps.stream().anyMatch(map -> map.target() == target);
    }

    /** The reflectance for a base colour: clipped at MAX_REFLECTANCE; the excess is stored for the surface. */
    private Rgb limited(Rgb colour) {
        double most = Surface.MAX_REFLECTANCE;
        excesses.add(new Rgb(Math.max(1, colour.r() / most), Math.max(1, colour.g() / most),
                Math.max(1, colour.b() / most)));
        return colour.atMost(most);
    }

    /** The name, followed by a number where another surface has the same name. */
    private String unique(String name) {
        String candidate = name;
        for (int n = surfaces.size(); !names.add(candidate); n++) {
            candidate = name + "#" + n;
        }
        return candidate;
    }

    /**
     * Adds an image to the maps of a surface, if the image is found and lies as the surface's first image does.
     *
     * @param first mapping of the surface's first image, if there is one
     * @return mapping of the surface's images
     */
    private Optional<TextureLie> addImage(List<ImageMap> maps, ImageMap.Target target, JsonCursor info, Rgb scale,
                                          Optional<TextureLie> first) throws IOException {
        TextureLie lie = lie(info);
        JsonCursor texture = root.at("textures").at(info.at("index").integer());
        Optional<JsonCursor> source = texture.optional("source");
        if (source.isEmpty()) {
            notes.note("", "textures without an image leave the base colour, a light grey where it is white",
                    texture.path());
            return first;
        }
        if (first.isPresent() && !first.get().equals(lie)) {
            notes.note("", "images that lie otherwise than the first of their surface are left out", info.path());
            return first;
        }
        Optional<ImageSource> image = image(source.get());
        if (image.isEmpty()) {
            return first;
        }
        int sampler = texture.index("sampler");
        maps.add(new ImageMap(target, image.get(), scale, false, true, false, 1, wrap(sampler, "wrapS"),
                wrap(sampler, "wrapT")));
        return Optional.of(lie);
    }

    private static TextureLie lie(JsonCursor info) throws SceneFormatException {
        int set = Math.max(0, info.index("texCoord"));
        Optional<JsonCursor> transform = info.extension("KHR_texture_transform");
        if (transform.isEmpty()) {
            return TextureLie.of(set, new double[] {1, 1}, 0, new double[2]);
        }
        int other = transform.get().index("texCoord");
        return TextureLie.of(other < 0 ? set : other, transform.get().numbers("scale", 1, 1),
                transform.get().number("rotation", 0), transform.get().numbers("offset", 0, 0));
    }

    private ImageMap.Wrap wrap(int sampler, String key) throws SceneFormatException {
        int mode = sampler < 0 ? -1 : root.at("samplers").at(sampler).index(key);
        return mode == GltfLists.CLAMP ? ImageMap.Wrap.EDGE
                : mode == GltfLists.MIRROR ? ImageMap.Wrap.MIRROR : ImageMap.Wrap.REPEAT;
    }

    private Optional<ImageSource> image(JsonCursor source) throws IOException {
        int number = source.integer();
        Optional<ImageSource> image = images.get(number);
        if (image == null) {
            image = find(root.at("images").at(number));
            images.put(number, image);
        }
        return image;
    }

    private Optional<ImageSource> find(JsonCursor image) throws IOException {
        String name = root.file() + ", " + image.path();
        Optional<JsonCursor> uri = image.optional("uri");
        if (uri.isEmpty()) {
            ByteBuffer bytes = buffers.view(image.at("bufferView"));
            return Optional.of(new ImageSource(name, Optional.of(bytes)));
        }
        if (Buffers.isData(uri.get())) {
            return Optional.of(new ImageSource(name, Optional.of(ByteBuffer.wrap(buffers.data(uri.get())))));
        }
        Optional<Path> file = buffers.found(uri.get());
        if (file.isEmpty()) {
            notes.note("", "images that are not found leave the base colour, a light grey where it is white",
                    uri.get().text());
        }
        return file.map(path -> ImageSource.file(path.toString()));
    }
}
