package radiosity.torture;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;

/** Puts a scene together: objects, instances of them, lights, a camera. */
final class SceneMaker {

    final Dice dice;
    final ObjectMaker object = new ObjectMaker();
    /** Corners of the room, units. */
    final double[] low = new double[3];
    final double[] high;
    double lightFlux;
    private final Path directory;
    private final boolean apart;
    private final StringBuilder items = new StringBuilder();
    private final StringBuilder lights = new StringBuilder();
    private double scale = 1;
    private final double[] shift = new double[3];
    private double moreArea;

    /** @param apart whether objects lie in a library and not beside the scene */
    SceneMaker(Dice dice, Path directory, boolean apart) throws IOException {
        this.dice = dice;
        this.directory = directory;
        this.apart = apart;
        high = new double[] {dice.between(1, 5), dice.between(1, 3), dice.between(1, 5)};
        Files.createDirectories(directory.resolve("scene"));
        Files.createDirectories(directory.resolve("library"));
    }

    double[] middle() {
        return new double[] {high[0] / 2, high[1] / 2, high[2] / 2};
    }

    /** A point of the room, a tenth off its walls. */
    double[] place() {
        return new double[] {high[0] * dice.between(.1, .9), high[1] * dice.between(.1, .9),
            high[2] * dice.between(.1, .9)};
    }

    /** Makes all of the scene larger, then puts it elsewhere. */
    void transform(double by, double[] to) {
        scale = by;
        System.arraycopy(to, 0, shift, 0, 3);
    }

    /** A room with walls of some colours; {@code sides} as of {@link ObjectMaker#box}, changed by the caller. */
    Material[] walls() {
        Material[] sides = new Material[6];
        Material wall = Material.wall("wall", dice);
        for (int i = 0; i < 6; i++) {
            sides[i] = dice.chance(.5) ? wall : Material.wall("wall " + i, dice);
        }
        return sides;
    }

    void room(Material[] sides) {
        object.box(low, high, true, sides);
    }

    /** A lamp in a room without a ceiling: all of the ceiling, or a rectangle cut out of it. */
    void ceilingWithLamp(Material ceiling, Material lamp) {
        double[] eye = middle();
        if (dice.chance(.25)) {
            object.rectangle(lamp, eye, 1, high[1], low, high);
            return;
        }
        double[] x = {0, high[0] * dice.between(.2, .45), high[0] * dice.between(.55, .8), high[0]};
        double[] z = {0, high[2] * dice.between(.2, .45), high[2] * dice.between(.55, .8), high[2]};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                object.rectangle(i == 1 && j == 1 ? lamp : ceiling, eye, 1, high[1],
                        new double[] {x[i], 0, z[j]}, new double[] {x[i + 1], 0, z[j + 1]});
            }
        }
    }

    void litRoom() {
        Material[] sides = walls();
        Material ceiling = sides[3];
        sides[3] = null;
        room(sides);
        ceilingWithLamp(ceiling, Material.lamp("lamp", dice.logarithmic(1, 100), dice));
    }

    /** A triangle about a point, with edges of some length. */
    void triangle(Material material, double[] about, double length) {
        double[][] corners = new double[3][3];
        for (double[] corner : corners) {
            for (int k = 0; k < 3; k++) {
                corner[k] = about[k] + length * dice.between(-.5, .5);
            }
        }
        object.polygon(material, null, corners);
    }

    /** A picture of a few random pixels beside the scene; its name. */
    String image() throws IOException {
        BufferedImage image = new BufferedImage(dice.integer(1, 16), dice.integer(1, 16), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                image.setRGB(x, y, dice.integer(0, 0xFFFFFF));
            }
        }
        ImageIO.write(image, "png", objects().resolve("image.png").toFile());
        return "image.png";
    }

    private Path objects() {
        return directory.resolve(apart ? "library" : "scene");
    }

    /** Writes another object and puts it into the scene several times, in every position. */
    void instances(ObjectMaker other, int count) throws IOException {
        Files.write(objects().resolve("thing.lwo"), dice.chance(.5) ? other.lwob() : other.lwo2());
        for (int i = 0; i < count; i++) {
            double[] at = place();
            double size = dice.between(.05, .3);
            double mirror = dice.chance(.3) ? -1 : 1;
            load("thing.lwo", at[0], at[1], at[2], dice.between(0, 360), dice.between(0, 360), dice.between(0, 360),
                    size * mirror, size, size * dice.between(.3, 1));
            if (i > 0 && dice.chance(.2)) {
                items.append("ParentObject 1\n");
            }
            moreArea += other.area() * size * size;
        }
    }

    private void load(String name, double... motion) {
        items.append("LoadObject ").append(apart ? "STOCK:" : "").append(name).append('\n')
                .append(motion("ObjectMotion", motion));
    }

    /** A light, lighted from about the ceiling downwards. */
    void light() {
        double intensity = dice.logarithmic(.1, 100);
        int type = dice.integer(0, 2);
        double range = dice.between(.5, 3);
        double[] at = place();
        lights.append("AddLight\nLightName Light\n").append(motion("LightMotion", at[0], at[1], at[2],
                dice.between(0, 360), dice.between(45, 90), 0, 1, 1, 1)).append("LightColor 255 240 200\n")
                .append(String.format(Locale.ROOT, "LgtIntensity %s\nLightType %d\nLightRange %s\n", intensity, type,
                        range)).append("ConeAngle 30\nEdgeAngle 5\n");
        double diagonal = Math.hypot(high[0], Math.hypot(high[1], high[2]));
        lightFlux += type == 0 ? intensity * Math.PI * diagonal * diagonal / 4
                : 4 * Math.PI * intensity * range * range;
    }

    private static String motion(String keyword, double... values) {
        StringBuilder text = new StringBuilder(keyword).append(" (unnamed)\n 9\n 1\n");
        for (double value : values) {
            text.append(' ').append(value);
        }
        return text.append("\n 0 0 0 0 0\nEndBehavior 1\n").toString();
    }

    /** Writes everything. */
    MadeScene made(SceneKind kind) throws IOException {
        boolean old = kind == SceneKind.IMAGES || dice.chance(.5);
        object.transform(scale, shift);
        Files.write(objects().resolve("room.lwo"), old ? object.lwob() : object.lwo2());
        StringBuilder text = new StringBuilder("LWSC\n1\n\nFirstFrame 0\n");
        text.append("LoadObject ").append(apart ? "STOCK:" : "").append("room.lwo\n")
                .append(motion("ObjectMotion", 0, 0, 0, 0, 0, 0, 1, 1, 1)).append(items).append(lights);
        if (dice.chance(.5)) {
            double[] m = middle();
            text.append("ShowCamera 1\n").append(motion("CameraMotion", m[0] * scale + shift[0],
                    m[1] * scale + shift[1], shift[2] + .1 * scale, 0, 0, 0, 1, 1, 1)).append("ZoomFactor 1.5\n");
        }
        Path file = directory.resolve("scene").resolve("scene.lws");
        Files.writeString(file, text);
        double size = Math.max(high[0], Math.max(high[1], high[2])) * scale;
        return new MadeScene(kind, file, apart ? directory.resolve("library") : null, apart ? "STOCK:" : null,
                object.area() + moreArea, lightFlux, size);
    }
}
