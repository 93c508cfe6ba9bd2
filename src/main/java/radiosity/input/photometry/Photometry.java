package radiosity.input.photometry;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import radiosity.input.file.InputFile;
import radiosity.scene.Light;
import radiosity.scene.Luminaire;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;

/**
 * What a luminaire's file says.
 *
 * @param intensity of the luminaire, cd
 * @param length    of its luminous opening in the plane of horizontal angle 0, m; of round ones, that of a rectangle as
 *                  large
 * @param width     of its luminous opening across, m
 * @param tilt      how its flux depends on how far it is tilted
 */
public record Photometry(LuminousIntensity intensity, double length, double width, Tilt tilt) {

    /** Edge of a square / diameter of a circle as large. */
    static final double ROUND = Math.sqrt(Math.PI) / 2;

    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    /**
     * Factors of flux by the angle between a luminaire's axis and straight down.
     *
     * @param angles  degrees, ascending, at least one
     * @param factors one for each
     */
    record Tilt(double[] angles, double[] factors) {

        static final Tilt NONE = new Tilt(new double[] {0}, new double[] {1});

        /** Interpolated; beyond the angles as at the nearest one. */
        double factor(double angle) {
            int i = 0;
            while (i < angles.length && angles[i] < angle) {
                i++;
            }
            if (i == 0 || i == angles.length) {
                return factors[Math.min(i, angles.length - 1)];
            }
            double part = (angle - angles[i - 1]) / (angles[i] - angles[i - 1]);
            return factors[i - 1] + part * (factors[i] - factors[i - 1]);
        }
    }

    /** A file beside this one, which it names. */
    interface Sibling {
        Optional<byte[]> read(String name) throws IOException;
    }

    /**
     * Reads a file of either format.
     *
     * @param maxBytes largest file that is read
     * @throws SceneFormatException if it is no luminaire's file, or a broken one
     * @throws IOException          if it cannot be read
     */
    public static Photometry read(Path file, long maxBytes) throws IOException {
        return of(InputFile.read(file, file.toString(), maxBytes), file.toString(), name -> {
            String plain = name.substring(1 + Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')));
            Path beside = file.resolveSibling(plain.replace("\0", ""));
            return java.nio.file.Files.isRegularFile(beside)
                    ? Optional.of(InputFile.read(beside, beside.toString(), maxBytes)) : Optional.empty();
        });
    }

    /**
     * Reads the bytes of a file that names no other.
     *
     * @param name for messages
     * @throws SceneFormatException if it is no luminaire's file, or a broken one
     */
    public static Photometry of(byte[] bytes, String name) throws IOException {
        return of(bytes, name, other -> Optional.empty());
    }

    private static Photometry of(byte[] bytes, String name, Sibling siblings) throws IOException {
        String text = new String(bytes, StandardCharsets.ISO_8859_1).replace("\u00ef\u00bb\u00bf", "");
        try {
            return IesParser.isIes(text) ? new IesParser(text, name, siblings).photometry()
                    : new EulumdatParser(text, name).photometry();
        } catch (IllegalArgumentException e) {
            throw new SceneFormatException(name, "", "a luminaire's intensities", e.getMessage());
        }
    }

    /**
     * A light of a scene that shines as this luminaire does.
     *
     * @param zero   direction of the plane of horizontal angle 0; of zero length: any that is level
     * @param colour factor of the intensities
     * @param metre  scene units
     * @throws IllegalArgumentException where it is dark
     */
    public Light at(String name, Vec3 position, Vec3 down, Vec3 zero, Rgb colour, double metre) {
        Vec3 level = Math.abs(down.unit().y()) > 0.999 ? new Vec3(1, 0, 0) : DOWN.cross(down);
        Vec3 beside = zero.minus(down.unit().times(zero.dot(down.unit())));
        double angle = StrictMath.toDegrees(StrictMath.acos(Math.max(-1, Math.min(1, down.unit().dot(DOWN)))));
        return new Light(name, Light.Kind.POINT, colour.times(intensity.max() * tilt.factor(angle)), position,
                down.unit(), Vec3.ZERO, Vec3.ZERO, metre, 0, 0, Optional.of(new Luminaire(intensity,
                        (beside.length() > 1e-6 ? beside : level).unit(), length * metre, width * metre)));
    }
}
