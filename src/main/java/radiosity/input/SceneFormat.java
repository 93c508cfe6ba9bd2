package radiosity.input;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import radiosity.input.file.FileSniffer;
import radiosity.input.lightwave.LightWaveReader;

/** Formats of scenes that can be read. A file is recognised by its content, or else by the extension of its name. */
public enum SceneFormat {

    LIGHTWAVE(Set.of("lws", "lwo")),
    GLTF(Set.of("gltf", "glb")),
    OBJ(Set.of("obj"));

    private static final Pattern GLTF_JSON = Pattern.compile("\\A\\s*\\{.*\"(asset|meshes|nodes|accessors)\"\\s*:.*",
            Pattern.DOTALL);
    /** First words of the lines that may precede the first vertex or material library of an OBJ file. */
    private static final Set<String> OBJ_BEFORE = Set.of("", "o", "g", "s", "usemtl", "mg", "vt", "vn");
    private static final Pattern OBJ_FIRST = Pattern.compile("mtllib\\s.*|v(\\s+[-+.\\deE]+){3,7}\\s*");

    private final Set<String> endings;

    SceneFormat(Set<String> endings) {
        this.endings = endings;
    }

    /**
     * The format of a file; empty for formats that cannot be read.
     *
     * @throws IOException where the file cannot be read
     */
    public static Optional<SceneFormat> of(Path file) throws IOException {
        return of(start(file), String.valueOf(file.getFileName()));
    }

    static byte[] start(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return in.readNBytes(FileSniffer.START);
        }
    }

    /**
     * The format of a file; empty for formats that cannot be read.
     *
     * @param start the first {@value FileSniffer#START} bytes of the file, or all
     * @param name  of the file
     */
    static Optional<SceneFormat> of(byte[] start, String name) {
        String text = new String(start, StandardCharsets.ISO_8859_1);
        String plain = text.startsWith("\u00EF\u00BB\u00BF") ? text.substring(3) : text;
        if (LightWaveReader.recognises(start)) {
            return Optional.of(LIGHTWAVE);
        }
        if (text.startsWith("glTF") || GLTF_JSON.matcher(plain).matches()) {
            return Optional.of(GLTF);
        }
        if (FileSniffer.foreign(start).isPresent()) {
            return Optional.empty();
        }
        if (isObj(plain)) {
            return Optional.of(OBJ);
        }
        String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        for (SceneFormat format : values()) {
            if (format.endings.contains(ending)) {
                return Optional.of(format);
            }
        }
        return Optional.empty();
    }

    private static boolean isObj(String text) {
        for (String line : text.split("[\r\n]+")) {
            String plain = line.strip();
            if (OBJ_FIRST.matcher(plain).matches()) {
                return true;
            }
            if (!plain.startsWith("#") && !OBJ_BEFORE.contains(plain.split("\\s", 2)[0])) {
                return false;
            }
        }
        return false;
    }
}
