package radiosity.input.lightwave;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * How a LightWave scene is to be read.
 *
 * @param frame        the frame whose motions and envelopes are taken; the scene's first if empty; negative infinity
 *                     stands for the first key of every channel
 * @param emission     which property of a surface makes it emit
 * @param content      directories in which objects are searched besides the scene's own
 * @param map          directories by the beginning of the paths that lie in them: {@code D:/projects} -> a directory
 * @param lights       what becomes of the scene's lights
 * @param srgb         colours of files are sRGB and are made linear; otherwise they are taken as written
 * @param strict       every warning is an error
 * @param maxBytes     largest file that is read, bytes
 * @param maxTriangles most triangles that a scene may have, all instances counted
 */
public record LightWaveOptions(OptionalDouble frame, Emission emission, List<Path> content, Map<String, Path> map,
                               Lights lights, boolean srgb, boolean strict, long maxBytes, int maxTriangles) {

    /** Which property makes a surface emit: LightWave's luminosity, or what the paper used (appendix B.2). */
    public enum Emission { LUMINOSITY, SPECULAR }

    /** Lights are taken where no surface emits, never, or always. */
    public enum Lights { AUTO, IGNORE, EMITTERS }

    /** Refuses limits that cannot be. */
    public LightWaveOptions {
        content = List.copyOf(content);
        map = Map.copyOf(map);
        if (maxBytes <= 0 || maxBytes > Integer.MAX_VALUE - 8 || maxTriangles <= 0) {
            throw new IllegalArgumentException("LightWave options: expected 1 to " + (Integer.MAX_VALUE - 8)
                    + " bytes and at least 1 triangle, got " + maxBytes + " and " + maxTriangles);
        }
    }

    /** First frame, luminosity, lights where nothing else shines, 256 MiB per file, 20 million triangles. */
    public static LightWaveOptions defaults() {
        return new LightWaveOptions(OptionalDouble.empty(), Emission.LUMINOSITY, List.of(), Map.of(), Lights.AUTO,
                false, false, 256L << 20, 20_000_000);
    }

    /** The same with another frame. */
    public LightWaveOptions withFrame(double value) {
        return new LightWaveOptions(OptionalDouble.of(value), emission, content, map, lights, srgb, strict, maxBytes,
                maxTriangles);
    }

    /** The same with another property that makes surfaces emit. */
    public LightWaveOptions withEmission(Emission value) {
        return new LightWaveOptions(frame, value, content, map, lights, srgb, strict, maxBytes, maxTriangles);
    }

    /** The same with other directories to search. */
    public LightWaveOptions withContent(List<Path> value) {
        return new LightWaveOptions(frame, emission, value, map, lights, srgb, strict, maxBytes, maxTriangles);
    }

    /** The same with other directories by the beginning of paths. */
    public LightWaveOptions withMap(Map<String, Path> value) {
        return new LightWaveOptions(frame, emission, content, value, lights, srgb, strict, maxBytes, maxTriangles);
    }

    /** The same with another use of the lights. */
    public LightWaveOptions withLights(Lights value) {
        return new LightWaveOptions(frame, emission, content, map, value, srgb, strict, maxBytes, maxTriangles);
    }

    /** The same with colours taken as sRGB or as written. */
    public LightWaveOptions withSrgb(boolean value) {
        return new LightWaveOptions(frame, emission, content, map, lights, value, strict, maxBytes, maxTriangles);
    }

    /** The same with or without warnings as errors. */
    public LightWaveOptions withStrict(boolean value) {
        return new LightWaveOptions(frame, emission, content, map, lights, srgb, value, maxBytes, maxTriangles);
    }

    /** The same with another limit of a file, bytes. */
    public LightWaveOptions withMaxBytes(long value) {
        return new LightWaveOptions(frame, emission, content, map, lights, srgb, strict, value, maxTriangles);
    }

    /** The same with another limit of a scene. */
    public LightWaveOptions withMaxTriangles(int value) {
        return new LightWaveOptions(frame, emission, content, map, lights, srgb, strict, maxBytes, value);
    }
}
