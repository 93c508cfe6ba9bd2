package radiosity.input.lightwave.lws;

import radiosity.scene.Affine;

/**
 * Position, rotation and scale of an item in time, in up to nine channels; cameras often have six only.
 *
 * @param channels 9 entries: 0 to 2 position, 3 to 5 heading, pitch and bank, 6 to 8 scale; null for missing channels
 * @param old      whether angles are in degrees (LWSC 1 and 2) and not in radians
 * @param inFrames whether times are in frames (LWSC 1) and not in seconds
 */
public record Motion(Envelope[] channels, boolean old, boolean inFrames) {

    static final int CHANNELS = 9;
    private static final int HEADING = 3;
    private static final int SCALE = 6;

    static final Motion NONE = new Motion(new Envelope[CHANNELS], false, false);

    /** Value of a channel, angles in radians; 1 for a missing scale, 0 for other missing channels. */
    double at(int channel, Instant instant) {
        double value = EnvelopeCurve.at(channels[channel], instant.time(inFrames), channel >= SCALE ? 1 : 0);
        return old && channel >= HEADING && channel < SCALE ? Math.toRadians(value) : value;
    }

    Affine position(Instant instant) {
        return Affine.move(at(0, instant), at(1, instant), at(2, instant));
    }

    Affine rotation(Instant instant) {
        return Turn.of(at(HEADING, instant), at(HEADING + 1, instant), at(HEADING + 2, instant));
    }

    double bank(Instant instant) {
        return at(HEADING + 2, instant);
    }

    Affine scale(Instant instant) {
        return Affine.scale(at(SCALE, instant), at(SCALE + 1, instant), at(SCALE + 2, instant));
    }

    /**
     * A time of the scene.
     *
     * @param frame           frame number; negative infinity for the first key of every channel
     * @param framesPerSecond above 0
     */
    public record Instant(double frame, double framesPerSecond) {

        double time(boolean inFrames) {
            return inFrames ? frame : frame / framesPerSecond;
        }
    }
}
