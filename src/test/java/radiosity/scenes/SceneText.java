package radiosity.scenes;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;

/** Writes a LightWave scene (LWSC 3): instances of layers with motions of one key each, then the camera. */
final class SceneText {

    private final StringBuilder text = new StringBuilder("""
            LWSC
            3

            FirstFrame 0
            LastFrame 0
            FrameStep 1
            FramesPerSecond 25

            """);
    private int items;

    /**
     * Where an item stands.
     *
     * @param x       position, scene units, as y and z
     * @param heading degrees, turns +z towards +x
     * @param pitch   degrees, turns +z towards -y
     * @param mirror  -1: reflected in x; else 1
     */
    record Place(double x, double y, double z, double heading, double pitch, int mirror) {

        static Place at(double x, double y, double z) {
            return new Place(x, y, z, 0, 0, 1);
        }

        Place turned(double degrees) {
            return new Place(x, y, z, degrees, pitch, mirror);
        }

        Place tilted(double degrees) {
            return new Place(x, y, z, heading, degrees, mirror);
        }

        Place mirrored() {
            return new Place(x, y, z, heading, pitch, -1);
        }
    }

    /** Adds an instance of a layer, 1 for the first, and returns its number, by which others name it as parent. */
    int instance(String file, int layer, Place place) {
        line("LoadObjectLayer " + layer + " " + file);
        motion("Object", place);
        text.append('\n');
        return items++;
    }

    /** The same as a part of an instance: its place is in the parent's own coordinates. */
    int instance(String file, int layer, Place place, int parent) {
        int number = instance(file, layer, place);
        text.setLength(text.length() - 1);
        line(String.format("ParentItem 1%07X", parent));
        text.append('\n');
        return number;
    }

    /** Ends the scene with its camera: square pixels; half the picture's height is 1 / zoom of the distance. */
    byte[] seenFrom(Place place, double zoom, int width, int height) {
        line("AmbientIntensity 0\n");
        line("AddCamera");
        line("CameraName Camera");
        motion("Camera", place);
        line("ZoomFactor " + number(zoom));
        line("FrameSize " + width + " " + height);
        line("PixelAspect 1");
        return text.toString().getBytes(StandardCharsets.US_ASCII);
    }

    private void motion(String kind, Place p) {
        line(kind + "Motion");
        line("NumChannels 9");
        double[] channels = {p.x, p.y, p.z, Math.toRadians(p.heading), Math.toRadians(p.pitch), 0, p.mirror, 1, 1};
        for (int c = 0; c < channels.length; c++) {
            line("Channel " + c);
            line("{ Envelope\n  1\n  Key " + number(channels[c]) + " 0 3 0 0 0 0 0 0\n  Behaviors 1 1\n}");
        }
    }

    private void line(String line) {
        text.append(line).append('\n');
    }

    private static String number(double x) {
        BigDecimal rounded = new BigDecimal(x).setScale(8, RoundingMode.HALF_EVEN).stripTrailingZeros();
        return rounded.signum() == 0 ? "0" : rounded.toPlainString();
    }
}
