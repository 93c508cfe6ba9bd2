package radiosity.input.obj;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.input.file.InputFile;
import radiosity.scene.ImageMap;
import radiosity.scene.ImageSource;
import radiosity.scene.Rgb;
import radiosity.scene.Srgb;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;

/** The materials of an OBJ file: finds and reads the file's libraries and makes surfaces of their materials. */
final class Materials {

    /** Most libraries in one line. */
    private static final int MOST_NAMES = 100;
    /** A name in quotes, or a word. */
    private static final Pattern QUOTED = Pattern.compile("\"[^\"]*\"|\\S+");

    private final FileSearch search;
    private final ReadOptions options;
    private final Diagnostics notes;
    private final Map<String, Material> described = new HashMap<>();

    Materials(FileSearch search, ReadOptions options, Diagnostics notes) {
        this.search = search;
        this.options = options;
        this.notes = notes;
    }

    /**
     * Reads libraries; each text is one name that may contain blanks, or several names between blanks, each of them
     * perhaps in quotes.
     */
    void read(Set<String> written) throws IOException {
        for (String names : written) {
            for (String name : search.file(names).isPresent() ? List.of(names) : split(names)) {
                Optional<Path> file = search.file(name);
                if (file.isEmpty()) {
                    notes.note("", "material libraries that are not found leave a light grey", name);
                } else {
                    String shown = search.shown(file.get());
                    Diagnostics about = notes.about(shown);
                    MtlParser.parse(InputFile.read(file.get(), shown, options.maxBytes()), about, described);
                    about.flush();
                }
            }
        }
    }

    private static List<String> split(String names) {
        return names.contains("\"")
                ? QUOTED.matcher(names).results().limit(MOST_NAMES).map(n -> TextLines.unquoted(n.group())).toList()
                : Arrays.asList(names.split("\\s+", MOST_NAMES));
    }

    /**
     * A material by its name; a light grey one where no library describes it.
     *
     * @param isColoured whether colours of vertices say what the material leaves open
     */
    Material material(String name, boolean isColoured) {
        Material known = described.get(name);
        if (known == null) {
            if (!isColoured) {
                notes.note("", "materials that no library describes are taken as a light grey", name);
            } else if (!name.equals(ObjParser.NO_MATERIAL)) {
                notes.note("", "materials that no library describes have the colours of vertices alone", name);
            }
            return new Material(name, false);
        }
        return known;
    }

    /**
     * The surface of a material. It reflects and emits on the side from which corners run counter-clockwise, or on both
     * sides where the options say so and the surface does not emit: a lamp that emits inward, too, has twice the flux.
     *
     * @param isColoured whether colours of vertices are factors of the reflectance
     */
    Surface surface(Material material, boolean isColoured) {
        TextureImage base = material.diffuseImage;
        Optional<ImageSource> baseImage = image(base);
        Rgb diffuse = reflectance(material, baseImage.isPresent(), isColoured);
        if (material.isTransparent()) {
            notes.note("", "transparent surfaces are taken as opaque (see --leave-out)", material.name);
        }
        List<ImageMap> maps = new ArrayList<>(0);
        TextureImage light = material.emittedImage;
        baseImage.ifPresent(image -> maps.add(map(ImageMap.Target.REFLECTANCE, image, diffuse, base)));
        if (maps.isEmpty() && !isColoured && diffuse.max() > Surface.MAX_REFLECTANCE) {
            tellClipped(material.name);
        }
        if (light != null && !maps.isEmpty() && !base.liesAs(light)) {
            notes.note("", "images that lie otherwise than the first of their surface are left out", light.file());
        } else {
            image(light).ifPresent(image -> maps.add(map(ImageMap.Target.EXITANCE, image, material.emitted(), light)));
        }
        boolean isTwoSided = options.twoSided() && light == null && material.emitted().max() == 0;
        return new Surface(material.name, material.emitted(), diffuse.atMost(Surface.MAX_REFLECTANCE), isTwoSided,
                maps);
    }

    /**
     * The reflectance of a material, which may be more than 1; without Kd it is a light grey, or white where an image
     * or the colour of a vertex is a factor of it.
     */
    Rgb reflectance(Material material, boolean hasImage, boolean hasColour) {
        Rgb written = !hasImage && hasColour && material.diffuse == null ? Rgb.grey(1) : material.diffuse();
        boolean isMissing = material.diffuseImage != null && !hasImage && !hasColour;
        Rgb colour = isMissing ? Surface.withoutImage(written) : written;
        return options.srgb() ? Srgb.linear(colour) : colour;
    }

    /** Says that the reflectance of a material, with images and colours of vertices, is taken as the largest one. */
    void tellClipped(String material) {
        notes.note("", "reflectances of 1 and more are taken as " + Surface.MAX_REFLECTANCE, material);
    }

    private Optional<ImageSource> image(TextureImage of) {
        if (of == null) {
            return Optional.empty();
        }
        Optional<Path> file = search.file(of.file());
        if (file.isEmpty()) {
            notes.note("", "images that are not found leave the base colour, a light grey where it is white",
                    of.file());
        }
        return file.map(path -> ImageSource.file(path.toString()));
    }

    private static ImageMap map(ImageMap.Target target, ImageSource image, Rgb scale, TextureImage lies) {
        ImageMap.Wrap wrap = lies.clamp() ? ImageMap.Wrap.EDGE : ImageMap.Wrap.REPEAT;
        return new ImageMap(target, image, scale, false, false, false, 1, wrap, wrap);
    }
}
