package radiosity.input.lightwave;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.input.lightwave.lwo.ObjectModel;
import radiosity.input.lightwave.lwo.SurfaceValues;
import radiosity.input.lightwave.lwo.TextureBlock;
import radiosity.scene.ImageMap;
import radiosity.scene.ImageMap.Target;
import radiosity.scene.ImageSource;
import radiosity.scene.Rgb;
import radiosity.settings.ReadOptions;

/**
 * Finds the images of an object's surfaces and determines the quantities that they vary.
 *
 * <p>A triangle has one set of texture coordinates. The first image whose file is found determines the coordinates for
 * its surface; another image is used only if its projection onto the points is the same.
 */
final class SurfaceImages {

    private static final Set<String> EVALUATED = Set.of("COLR", "DIFF", "LUMI", "LUMC");
    /** Properties by whose images surfaces would let light through or mirror it. */
    private static final Set<String> LEFT_OUT = Set.of("TRAN", "REFL");

    private SurfaceImages() {
    }

    /** Removes the textures that are not evaluated or not usable from an object's surfaces; unusable ones are noted. */
    static void find(ObjectModel object, FileSearch search, Diagnostics notes) {
        for (SurfaceValues surface : object.surfaces.values()) {
            List<TextureBlock> usable = new ArrayList<>(0);
            for (TextureBlock texture : surface.textures) {
                if (isWanted(texture, object, surface, notes) && isFound(texture, search, notes)) {
                    add(texture, usable, surface, notes);
                }
            }
            surface.textures.clear();
            surface.textures.addAll(usable);
        }
    }

    private static boolean isWanted(TextureBlock texture, ObjectModel object, SurfaceValues surface,
            Diagnostics notes) {
        texture.image = texture.image == null ? object.clips.get(texture.clip) : texture.image;
        if (texture.enabled && texture.opacity > 0 && LEFT_OUT.contains(texture.channel)) {
            notes.note("", "images on transparency and reflection are left out", surface.name);
        }
        boolean evaluated = texture.enabled && texture.opacity > 0 && EVALUATED.contains(texture.channel);
        if (!evaluated) {
            return false;
        }
        if (texture.image == null || texture.image.isEmpty() || texture.image.equals("(none)")) {
            notes.note("", "textures without an image are left out", surface.name);
            return false;
        }
        if (texture.projection == TextureBlock.Projection.FRONT || !texture.hasSoundNumbers()) {
            notes.note("", "images projected from the camera or by unsound numbers are left out", surface.name);
            return false;
        }
        if (texture.world && texture.projection != TextureBlock.Projection.UV) {
            notes.note("", "images placed in the scene's coordinates are placed in the object's", surface.name);
        }
        return true;
    }

    private static boolean isFound(TextureBlock texture, FileSearch search, Diagnostics notes) {
        String path = texture.image.replaceFirst(" *\\(sequence\\)$", "");
        Optional<Path> file = search.file(path);
        texture.found = file.map(Path::toString).orElse(null);
        if (file.isEmpty()) {
            notes.note("", "images that are not found leave the base colour", path);
        }
        return file.isPresent();
    }

    private static void add(TextureBlock texture, List<TextureBlock> usable, SurfaceValues surface, Diagnostics notes) {
        if (usable.stream().anyMatch(t -> t.channel.equals(texture.channel))) {
            notes.note("", "of several images for one property the first is taken", surface.name);
        } else if (usable.isEmpty() || usable.get(0).liesAs(texture)) {
            usable.add(texture);
        } else {
            notes.note("", "images that lie otherwise than the first of their surface are left out", surface.name);
        }
    }

    /** The variation of a surface's reflectance and exitance by its images, for the emission named in the options. */
    static List<ImageMap> maps(SurfaceValues surface, ReadOptions options) {
        List<ImageMap> maps = new ArrayList<>(0);
        boolean specular = options.emission() == ReadOptions.Emission.SPECULAR;
        double share = specular ? surface.specular : surface.luminosity;
        boolean mayEmit = share > 0 || surface.textures.stream().anyMatch(t -> t.channel.equals("LUMI"));
        Rgb colour = SurfaceValues.linear(surface.colour, options.srgb());
        for (TextureBlock texture : surface.textures) {
            switch (texture.channel) {
                case "COLR" -> {
                    maps.add(map(texture, Target.REFLECTANCE, Rgb.grey(surface.diffuse), false));
                    if (specular ? share > 0 : mayEmit && surface.luminousColour == null) {
                        maps.add(map(texture, Target.EXITANCE, Rgb.grey(share), false));
                    }
                }
                case "DIFF" -> maps.add(map(texture, Target.REFLECTANCE, colour, true));
                case "LUMI" -> {
                    if (!specular) {
                        Rgb light = surface.luminousColour == null ? surface.colour : surface.luminousColour;
                        maps.add(map(texture, Target.EXITANCE, SurfaceValues.linear(light, options.srgb()), true));
                    }
                }
                default -> {
                    if (!specular && mayEmit) {
                        maps.add(map(texture, Target.EXITANCE, Rgb.grey(share), false));
                    }
                }
            }
        }
        return maps;
    }

    private static ImageMap map(TextureBlock texture, Target target, Rgb scale, boolean grey) {
        return new ImageMap(target, ImageSource.file(texture.found), SurfaceValues.sound(scale), grey, false,
                texture.negative, Math.min(1, texture.opacity), texture.wrapU, texture.wrapV);
    }
}
