package radiosity.input.photometry;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import radiosity.input.file.FileSniffer;
import radiosity.input.file.InputFile;
import radiosity.scene.Light;
import radiosity.scene.Luminaire;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;

/**
 * The photometry of a luminaire, from its file.
 *
 * @param intensity intensity by direction, cd
 * @param length    length of the luminous opening in the plane of horizontal angle 0, m; a round opening counts as a
 *                  rectangle of the same area
 * @param width     width of the luminous opening across that plane, m
 * @param tilt      flux by the angle of tilt
 */
public record Photometry(LuminousIntensity intensity, double length, double width, Tilt tilt) {

    /** Edge of a square / diameter of a circle of the same area. */
    static final double ROUND = Math.sqrt(Math.PI) / 2;

    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    /**
     * Factors of the flux by the angle between a luminaire's axis and straight down.
     *
     * @param angles  degrees, ascending, at least one
     * @param factors one per angle
     */
    record Tilt(double[] angles, double[] factors) {

        static final Tilt NONE = new Tilt(new double[] {0}, new double[] {1});

        /** Linear interpolation at an angle in degrees; beyond the angles the value of the nearest one. */
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

    /** Reads a file that the photometric file names, from the same directory; empty if there is none. */
    interface Sibling {
        Optional<byte[]> read(String name) throws IOException;
    }

    /**
     * Reads a file of either format.
     *
     * @param maxBytes largest size of a file, bytes
     * @throws SceneFormatException if the content is not a valid photometric file
     * @throws IOException          if the file cannot be read
     */
    public static Photometry read(Path file, long maxBytes) throws IOException {
        return of(InputFile.read(file, file.toString(), maxBytes), file.toString(), name -> {
            String plain = name.substring(1 + Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')));
            Path beside = file.resolveSibling(plain.replace("\0", ""));
            return Files.isRegularFile(beside)
                    ? Optional.of(InputFile.read(beside, beside.toString(), maxBytes)) : Optional.empty();
        });
    }

    /**
     * Reads the content of a file that names no other file.
     *
     * @param name name of the file in messages
     * @throws SceneFormatException if the content is not a valid photometric file
     */
    public static Photometry of(byte[] bytes, String name) throws IOException {
        return of(bytes, name, other -> Optional.empty());
    }

    private static Photometry of(byte[] bytes, String name, Sibling siblings) throws IOException {
        String text = new String(bytes, StandardCharsets.ISO_8859_1).replace("\u00ef\u00bb\u00bf", "");
        if (!IesParser.isIes(text) && !EulumdatParser.isEulumdat(text)) {
            throw new SceneFormatException(name, "", "an IES or EULUMDAT file", FileSniffer.describe(bytes));
        }
        try {
            return IesParser.isIes(text) ? new IesParser(text, name, siblings).photometry()
                    : new EulumdatParser(text, name).photometry();
        } catch (IllegalArgumentException e) {
            throw new SceneFormatException(name, "", "a luminaire's intensities", e.getMessage());
        }
    }

    /**
     * A point light with this luminaire's intensities, in a photometric scene.
     *
     * @param down   direction of the luminaire's axis, of any length above 0
     * @param zero   direction of the plane of horizontal angle 0; a horizontal one is used if zero is 0 or along down
     * @param colour factor of the intensities
     * @param metre  scene units per metre
     * @throws IllegalArgumentException where all intensities are 0
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
