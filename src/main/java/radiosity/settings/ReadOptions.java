package radiosity.settings;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import radiosity.scene.Units;

/**
 * Options for reading a scene.
 *
 * @param frame        LightWave: the frame at which motions and envelopes are evaluated; empty: the scene's first
 *                     frame; negative infinity: the first key of every channel
 * @param emission     LightWave: the property of a surface that makes the surface emit
 * @param content      directories that are searched for objects besides the scene's own directory
 * @param map          directories that replace the beginnings of paths in files: {@code D:/projects} -> a directory
 * @param lights       use of the scene's lights
 * @param srgb         whether colours in files are sRGB, which are made linear; else colours are taken as linear
 * @param twoSided     OBJ, whose files do not say: whether surfaces that do not emit reflect on both sides
 * @param strict       whether every warning is an error
 * @param maxBytes     largest size of a file, bytes
 * @param maxTriangles largest number of triangles of a scene, those of all instances counted
 * @param units        unit of length and kind of light (radiometric or photometric), where the file does not say
 * @param luminaires   files (IES, EULUMDAT) by the name of the lights that get the file's distribution, or by x,y,z
 * @param up           OBJ, whose files do not say: the axis that points up; z becomes y, and y becomes -z
 * @param leftOut      names of surfaces and objects that are left out of the scene
 */
public record ReadOptions(OptionalDouble frame, Emission emission, List<Path> content, Map<String, Path> map,
                               Lights lights, boolean srgb, boolean twoSided, boolean strict, long maxBytes,
                               int maxTriangles, Units units, Map<String, Path> luminaires, Up up,
                               Set<String> leftOut) {

    /** Property that makes a surface emit: LightWave's luminosity, or the specular value as in the paper (B.2). */
    public enum Emission { LUMINOSITY, SPECULAR }

    /** Use of lights: as the format means them (LightWave: only where no surface emits), never, or always. */
    public enum Lights { AUTO, IGNORE, EMITTERS }

    /** The axis of a file that points up. */
    public enum Up { Y, Z }

    /** @throws IllegalArgumentException where a limit is not above 0, or the size exceeds the longest array */
    public ReadOptions {
        content = List.copyOf(content);
        map = Map.copyOf(map);
        luminaires = Map.copyOf(luminaires);
        leftOut = Set.copyOf(leftOut);
        if (maxBytes <= 0 || maxBytes > Integer.MAX_VALUE - 8 || maxTriangles <= 0) {
            throw new IllegalArgumentException("options: expected 1 to " + (Integer.MAX_VALUE - 8)
                    + " bytes and at least 1 triangle, got " + maxBytes + " and " + maxTriangles);
        }
    }

    /** First frame, luminosity, lights as the format means them, linear colours, 256 MiB per file, 20e6 triangles. */
    public static ReadOptions defaults() {
        return new ReadOptions(OptionalDouble.empty(), Emission.LUMINOSITY, List.of(), Map.of(), Lights.AUTO, false,
                false, false, 256L << 20, 20_000_000, Units.UNKNOWN, Map.of(),
                Up.Y, Set.of());
    }

    /** These options with another frame. */
    public ReadOptions withFrame(double value) {
        return new ReadOptions(OptionalDouble.of(value), emission, content, map, lights, srgb, twoSided, strict,
                maxBytes, maxTriangles, units, luminaires, up, leftOut);
    }

    /** These options with another property that makes surfaces emit. */
    public ReadOptions withEmission(Emission value) {
        return new ReadOptions(frame, value, content, map, lights, srgb, twoSided, strict, maxBytes, maxTriangles,
                units, luminaires, up, leftOut);
    }

    /** These options with other directories to search. */
    public ReadOptions withContent(List<Path> value) {
        return new ReadOptions(frame, emission, value, map, lights, srgb, twoSided, strict, maxBytes, maxTriangles,
                units, luminaires, up, leftOut);
    }

    /** These options with other directories for the beginnings of paths. */
    public ReadOptions withMap(Map<String, Path> value) {
        return new ReadOptions(frame, emission, content, value, lights, srgb, twoSided, strict, maxBytes,
                maxTriangles, units, luminaires, up, leftOut);
    }

    /** These options with another use of the lights. */
    public ReadOptions withLights(Lights value) {
        return new ReadOptions(frame, emission, content, map, value, srgb, twoSided, strict, maxBytes, maxTriangles,
                units, luminaires, up, leftOut);
    }

    /** These options with colours taken as sRGB or as linear. */
    public ReadOptions withSrgb(boolean value) {
        return new ReadOptions(frame, emission, content, map, lights, value, twoSided, strict, maxBytes, maxTriangles,
                units, luminaires, up, leftOut);
    }

    /** These options with surfaces of OBJ that have two sides, or one. */
    public ReadOptions withTwoSided(boolean value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, value, strict, maxBytes, maxTriangles,
                units, luminaires, up, leftOut);
    }

    /** These options with or without warnings as errors. */
    public ReadOptions withStrict(boolean value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, twoSided, value, maxBytes, maxTriangles,
                units, luminaires, up, leftOut);
    }

    /** These options with another largest size of a file, bytes. */
    public ReadOptions withMaxBytes(long value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, twoSided, strict, value, maxTriangles,
                units, luminaires, up, leftOut);
    }

    /** These options with another largest number of triangles. */
    public ReadOptions withMaxTriangles(int value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, twoSided, strict, maxBytes, value, units,
                luminaires, up, leftOut);
    }

    /** These options with other units for files that do not say theirs. */
    public ReadOptions withUnits(Units value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, twoSided, strict, maxBytes, maxTriangles,
                value, luminaires, up, leftOut);
    }

    /** These options with other files of luminaires. */
    public ReadOptions withLuminaires(Map<String, Path> value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, twoSided, strict, maxBytes, maxTriangles,
                units, value, up, leftOut);
    }

    /** These options with another axis of OBJ that points up. */
    public ReadOptions withUp(Up value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, twoSided, strict, maxBytes, maxTriangles,
                units, luminaires, value, leftOut);
    }

    /** These options with other surfaces and objects that are left out, by their names. */
    public ReadOptions withLeftOut(Set<String> value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, twoSided, strict, maxBytes, maxTriangles,
                units, luminaires, up, value);
    }
}
