package radiosity.settings;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import radiosity.scene.Units;

/**
 * How a scene is to be read.
 *
 * @param frame        LightWave: the frame whose motions and envelopes are taken; the scene's first if empty; negative
 *                     infinity stands for the first key of every channel
 * @param emission     LightWave: which property of a surface makes it emit
 * @param content      directories in which objects are searched besides the scene's own
 * @param map          directories by the beginning of the paths that lie in them: {@code D:/projects} -> a directory
 * @param lights       what becomes of the scene's lights
 * @param srgb         colours of files are sRGB and are made linear; otherwise they are taken as written
 * @param strict       every warning is an error
 * @param maxBytes     largest file that is read, bytes
 * @param maxTriangles most triangles that a scene may have, all instances counted
 * @param units        of length, where the format leaves it open, and whether light is photometric where it is not said
 * @param luminaires   files (IES, EULUMDAT) by the name of the lights that shine so, or by x,y,z
 */
public record ReadOptions(OptionalDouble frame, Emission emission, List<Path> content, Map<String, Path> map,
                               Lights lights, boolean srgb, boolean strict, long maxBytes, int maxTriangles,
                               Units units, Map<String, Path> luminaires) {

    /** Which property makes a surface emit: LightWave's luminosity, or what the paper used (appendix B.2). */
    public enum Emission { LUMINOSITY, SPECULAR }

    /** Lights are taken as the format means them (LightWave: where no surface emits), never, or always. */
    public enum Lights { AUTO, IGNORE, EMITTERS }

    /** Refuses limits that cannot be. */
    public ReadOptions {
        content = List.copyOf(content);
        map = Map.copyOf(map);
        luminaires = Map.copyOf(luminaires);
        if (maxBytes <= 0 || maxBytes > Integer.MAX_VALUE - 8 || maxTriangles <= 0) {
            throw new IllegalArgumentException("options: expected 1 to " + (Integer.MAX_VALUE - 8)
                    + " bytes and at least 1 triangle, got " + maxBytes + " and " + maxTriangles);
        }
    }

    /** First frame, luminosity, lights where nothing else shines, 256 MiB per file, 20 million triangles. */
    public static ReadOptions defaults() {
        return new ReadOptions(OptionalDouble.empty(), Emission.LUMINOSITY, List.of(), Map.of(), Lights.AUTO,
                false, false, 256L << 20, 20_000_000, Units.UNKNOWN, Map.of());
    }

    /** The same with another frame. */
    public ReadOptions withFrame(double value) {
        return new ReadOptions(OptionalDouble.of(value), emission, content, map, lights, srgb, strict, maxBytes,
                maxTriangles, units, luminaires);
    }

    /** The same with another property that makes surfaces emit. */
    public ReadOptions withEmission(Emission value) {
        return new ReadOptions(frame, value, content, map, lights, srgb, strict, maxBytes, maxTriangles, units,
                luminaires);
    }

    /** The same with other directories to search. */
    public ReadOptions withContent(List<Path> value) {
        return new ReadOptions(frame, emission, value, map, lights, srgb, strict, maxBytes, maxTriangles, units,
                luminaires);
    }

    /** The same with other directories by the beginning of paths. */
    public ReadOptions withMap(Map<String, Path> value) {
        return new ReadOptions(frame, emission, content, value, lights, srgb, strict, maxBytes, maxTriangles, units,
                luminaires);
    }

    /** The same with another use of the lights. */
    public ReadOptions withLights(Lights value) {
        return new ReadOptions(frame, emission, content, map, value, srgb, strict, maxBytes, maxTriangles, units,
                luminaires);
    }

    /** The same with colours taken as sRGB or as written. */
    public ReadOptions withSrgb(boolean value) {
        return new ReadOptions(frame, emission, content, map, lights, value, strict, maxBytes, maxTriangles, units,
                luminaires);
    }

    /** The same with or without warnings as errors. */
    public ReadOptions withStrict(boolean value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, value, maxBytes, maxTriangles, units,
                luminaires);
    }

    /** The same with another limit of a file, bytes. */
    public ReadOptions withMaxBytes(long value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, strict, value, maxTriangles, units,
                luminaires);
    }

    /** The same with another limit of a scene. */
    public ReadOptions withMaxTriangles(int value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, strict, maxBytes, value, units, luminaires);
    }

    /** The same with other units, for formats that leave them open. */
    public ReadOptions withUnits(Units value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, strict, maxBytes, maxTriangles, value,
                luminaires);
    }

    /** The same with other luminaires, by the name of the light whose place they take. */
    public ReadOptions withLuminaires(Map<String, Path> value) {
        return new ReadOptions(frame, emission, content, map, lights, srgb, strict, maxBytes, maxTriangles, units,
                value);
    }
}
