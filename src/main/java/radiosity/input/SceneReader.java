package radiosity.input;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import radiosity.gltf.GltfModel;
import radiosity.input.assembly.LeftOut;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSniffer;
import radiosity.input.file.InputFile;
import radiosity.input.gltf.GltfReader;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.input.obj.ObjReader;
import radiosity.input.photometry.Luminaires;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;

/** Reads scenes of all supported formats: LightWave, glTF and OBJ. */
public final class SceneReader {

    private SceneReader() {
    }

    /**
     * Reads a scene's file and the files that it names: objects, materials, bytes, luminaires. Images are read later,
     * see {@link radiosity.output.image.SurfaceMaps}.
     *
     * @param file     a LightWave scene or object, a glTF file or binary, or an OBJ file
     * @param options  for reading the scene
     * @param warnings receives a line for each kind of thing that was left out or repaired, with file and place
     * @return a scene with at least one triangle
     * @throws SceneFormatException if the file is of another kind, which the message names, if the content cannot be
     *                              used, or under {@code strict} at the first warning
     * @throws IOException if a file cannot be read
     */
    public static Scene read(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        String name = String.valueOf(file.getFileName());
        InputFile.check(file, name);
        byte[] start = SceneFormat.start(file);
        Optional<SceneFormat> format = SceneFormat.of(start, name);
        if (format.isEmpty()) {
            throw new SceneFormatException(name, "", "a scene", FileSniffer.describe(start, name)
                    + (FileSniffer.isUtf16(start) ? "; LightWave scenes, glTF and OBJ are in UTF-8 or ASCII"
                    : "; LightWave, glTF and OBJ are read"));
        }
        Diagnostics notes = new Diagnostics(name, warnings, options.strict());
        if (format.get() != SceneFormat.LIGHTWAVE && options.frame().isPresent()) {
            notes.note("", "a frame is chosen for LightWave only");
        }
        if (format.get() != SceneFormat.LIGHTWAVE && options.emission() != ReadOptions.Emission.LUMINOSITY) {
            notes.note("", "a property that emits is chosen for LightWave only");
        }
        if (format.get() == SceneFormat.GLTF && options.srgb()) {
            notes.note("", "--srgb is for LightWave and OBJ only; glTF says itself what is sRGB");
        }
        if (format.get() != SceneFormat.OBJ && options.twoSided()) {
            notes.note("", "--two-sided is for OBJ only; LightWave and glTF say which surfaces have two sides");
        }
        if (format.get() != SceneFormat.OBJ && options.up() != ReadOptions.Up.Y) {
            notes.note("", "--up is for OBJ only; in LightWave and glTF y points up");
        }
        notes.flush();
        Scene whole = switch (format.get()) {
            case LIGHTWAVE -> LightWaveReader.read(file, options, warnings).with(options.units());
            case OBJ -> ObjReader.read(file, options, warnings).with(options.units());
            case GLTF -> GltfReader.read(file, options, warnings);
        };
        return Luminaires.place(LeftOut.of(whole, options.leftOut()), options);
    }

    /**
     * The unchanged model of a glTF file, to be written again with additions; empty for other formats.
     *
     * @param options with which the scene was read
     * @param scene   that was read from the file
     */
    public static Optional<GltfModel> original(Path file, ReadOptions options, Scene scene) throws IOException {
        return SceneFormat.of(file).equals(Optional.of(SceneFormat.GLTF))
                ? Optional.of(GltfReader.original(file, options, scene)) : Optional.empty();
    }
}
