package radiosity.input.lightwave;

import static radiosity.input.lightwave.Iff.chunk;
import static radiosity.input.lightwave.Iff.f4;
import static radiosity.input.lightwave.Iff.form;
import static radiosity.input.lightwave.Iff.join;
import static radiosity.input.lightwave.Iff.s0;
import static radiosity.input.lightwave.Iff.sub;
import static radiosity.input.lightwave.Iff.text;
import static radiosity.input.lightwave.Iff.u2;
import static radiosity.input.lightwave.Iff.u4;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;

/**
 * Scenes whose renders are compared between machines, as files: {@code images.lws}, a room in colours with images on
 * its walls; {@code lamps.lws}, the same room with two lamps and a spot light; {@code closed.lws}, the room with
 * nothing in it but a lamp, which is proven closed.
 *
 * <p>All objects are turned by angles that are no multiples of a quarter turn, images lie round a sphere and a
 * cylinder: whatever computes a sine, an arc tangent or a power takes part in the result.
 */
public final class GoldenScenes {

    private static final String ROOM = "LWSC\n3\n\nLoadObjectLayer 1 room.lwo\n"
            + Scenes.motion3("ObjectMotion", 0.1, 0.2, 0.3, 0.37, 0.11, 0.23, 1, 1, 1);
    private static final String LAMP = "\nLoadObjectLayer 1 lamp.lwo\n"
            + Scenes.motion3("ObjectMotion", 0.2, 0.7, -0.1, 1.3, 0.4, 0.1, 1, 1, 1) + "ParentItem 10000000\n";
    private static final String PLACES = ROOM + "\nLoadObjectLayer 1 block.lwo\n"
            + Scenes.motion3("ObjectMotion", -0.3, -0.75, 0.2, 0.53, 0, 0, 1, 1, 1) + "ParentItem 10000000\n" + LAMP;
    private static final String SECOND_LAMP = "\nLoadObjectLayer 1 glow.lwo\n"
            + Scenes.motion3("ObjectMotion", 0.6, -0.6, 0.5, 0.2, 0.7, 0, 1, 1, 1) + "ParentItem 10000000\n"
            + "\nAddLight\nLightName Spot\n"
            + Scenes.motion3("LightMotion", 0.4, 0.5, 0.5, 2.5, 0.9, 0, 1, 1, 1)
            + "LightColor 1 0.8 0.5\nLightIntensity 2\nLightType 2\nLightConeAngle 0.5\nLightEdgeAngle 0.1\n";

    private GoldenScenes() { }

    /** Writes all files into a folder that exists. */
    public static void write(Path folder) throws IOException {
        ImageIO.write(image(), "png", folder.resolve("tiles.png").toFile());
        Files.write(folder.resolve("room.lwo"),
                box(-1, true, List.of("left", "right", "floor", "ceiling", "near", "far"),
                chunk("CLIP", u4(1), sub("STIL", s0("tiles.png"))),
                surface("left", 0.8, 0.3, 0.2, 0), surface("right", 0.2, 0.5, 0.8, 0),
                surface("floor", 1, 1, 1, 0, projected(2, 1)), surface("ceiling", 0.9, 0.9, 0.8, 0),
                surface("near", 0.6, 0.7, 0.3, 0), surface("far", 1, 1, 1, 0, projected(1, 0))));
        Files.write(folder.resolve("block.lwo"),
                box(-0.25, false, List.of("block"), surface("block", 0.5, 0.6, 0.7, 0)));
        Files.write(folder.resolve("lamp.lwo"), box(-0.1, false, List.of("lamp"), surface("lamp", 1, 0.9, 0.7, 20)));
        Files.write(folder.resolve("glow.lwo"), box(-0.15, false, List.of("glow"), surface("glow", 0.3, 0.5, 1, 5)));
        Files.writeString(folder.resolve("images.lws"), PLACES);
        Files.writeString(folder.resolve("lamps.lws"), PLACES + SECOND_LAMP);
        Files.writeString(folder.resolve("closed.lws"), ROOM + LAMP);
    }

    /** A small image without a loss, in which no two pixels are alike. */
    private static BufferedImage image() {
        BufferedImage image = new BufferedImage(8, 4, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 32; i++) {
            image.setRGB(i % 8, i / 8, 60 + 6 * i << 16 | (90 + 37 * i % 150) << 8 | 40 + 83 * i % 200);
        }
        return image;
    }

    /**
     * An LWO2 object: a cube about the origin.
     *
     * @param low    the lowest x, y and z, below 0
     * @param inward whether the fronts of its sides look inward
     * @param tags   surfaces of its sides -x, +x, -y, +y, -z, +z, repeated as often as needed
     */
    private static byte[] box(double low, boolean inward, List<String> tags, byte[]... more) {
        double[] points = new double[24];
        for (int i = 0; i < points.length; i++) {
            points[i] = (i / 3 >> i % 3 & 1) == 0 ? low : -low;
        }
        byte[] polygons = text("FACE");
        byte[] surfaces = text("SURF");
        for (int side = 0; side < 6; side++) {
            polygons = join(polygons, u2(4), u2(corners(side / 2, side % 2, side % 2 == 1 ^ inward)));
            surfaces = join(surfaces, u2(side, side % tags.size()));
        }
        byte[][] names = tags.stream().map(Iff::s0).toArray(byte[][]::new);
        return form("LWO2", chunk("TAGS", names), Objects.layer(0, 0), chunk("PNTS", f4(points)),
                chunk("POLS", polygons), chunk("PTAG", surfaces), join(more));
    }

    /** Points of a side of a cube, where bit a of a point's number says whether it lies high on axis a. */
    private static int[] corners(int axis, int high, boolean upward) {
        int u = 1 << (axis + 1) % 3;
        int v = 1 << (axis + 2) % 3;
        int[] ring = upward ? new int[] {0, u, u | v, v} : new int[] {0, v, u | v, u};
        return Arrays.stream(ring).map(point -> point | high << axis).toArray();
    }

    private static byte[] surface(String name, double r, double g, double b, double exitance, byte[]... more) {
        return Objects.lwo2Surface(name, "", Objects.colour(r, g, b), Objects.share("DIFF", 0.7),
                Objects.share("LUMI", exitance), join(more));
    }

    /** @param projection 1 round a cylinder, 2 round a sphere */
    private static byte[] projected(int projection, int axis) {
        return SoundFiles.imageBlock("COLR", projection, sub("AXIS", u2(axis)),
                sub("TMAP", sub("CNTR", f4(0.1, 0.2, 0.1), u2(0)), sub("SIZE", f4(1.5, 2.5, 1.7), u2(0)),
                        sub("ROTA", f4(0.3, 0.7, 0.2), u2(0))), sub("WRPW", f4(1), u2(0)), sub("WRPH", f4(1), u2(0)));
    }
}
