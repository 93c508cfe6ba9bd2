package radiosity.input.lightwave;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** Writes and reads small scenes, for tests. */
final class Scenes {

    private Scenes() {
    }

    /** Reads a scene that stands beside a square from (0, 0, 0) to (1, 1, 0), room.lwo. */
    static Scene read(Path folder, String text, ReadOptions options, List<String> told) throws IOException {
        Files.write(folder.resolve("room.lwo"), Objects.square());
        return LightWaveReader.read(Files.writeString(folder.resolve("a.lws"), text), options, told::add);
    }

    /** A motion of version 1 with one key: position, heading, pitch, bank in degrees, scale. */
    static String motion1(double... values) {
        StringBuilder text = new StringBuilder("ObjectMotion (unnamed)\n 9\n 1\n");
        for (double value : values) {
            text.append(' ').append(value);
        }
        return text.append("\n 0 0 0 0 0\nEndBehavior 1\n").toString();
    }

    /** A motion of version 3 and later with one key for each channel, angles in radians. */
    static String motion3(String keyword, double... values) {
        StringBuilder text = new StringBuilder(keyword).append("\nNumChannels 9\n");
        for (int c = 0; c < values.length; c++) {
            text.append("Channel ").append(c).append("\n{ Envelope\n  1\n  Key ").append(values[c])
                    .append(" 0 0 0 0 0 0 0 0\n  Behaviors 1 1\n}\n");
        }
        return text.toString();
    }

    /** The first corner of each square read, in left-handed coordinates: where the object's origin is. */
    static Vec3 origin(Scene scene, int square) {
        return left(scene.corner(2 * square, 0));
    }

    /** Where (1, 1, 0) of a square is, left-handed; the corner opposite to the origin. */
    static Vec3 far(Scene scene, int square) {
        Vec3 origin = scene.corner(2 * square, 0);
        for (int k = 1; k < 3; k++) {
            for (int j = 1; j < 3; j++) {
                if (scene.corner(2 * square, k).equals(scene.corner(2 * square + 1, j))) {
                    return left(scene.corner(2 * square, k));
                }
            }
        }
        return left(origin);
    }

    /** A point of a scene in LightWave's left-handed space. */
    static Vec3 left(Vec3 p) {
        return new Vec3(p.x(), p.y(), -p.z());
    }
}
