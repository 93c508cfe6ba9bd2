package radiosity.mesh;

import radiosity.mesh.room.ClosedRooms;

/**
 * Weights of radiosities where it is decided how closely to look: the inverse mean of each channel, so that all
 * channels get the same relative accuracy. Closed rooms exchange no light, so of several rooms each has its own
 * weights: a dim room beside a much brighter one is as accurate as it is alone.
 *
 * @param rooms    which faces stand in which closed room; null where weights are the same everywhere
 * @param channels number of channels of the light
 * @param value    m²/W, one per channel; with several rooms first for faces in no room, then for each room
 */
public record Weights(ClosedRooms rooms, int channels, double[] value) {

    /** The number of weights for a scene. */
    public static int count(ClosedRooms rooms, int channels) {
        return rooms.count() > 1 ? channels * (1 + rooms.count()) : channels;
    }

    /** Weights that are the same for all faces. */
    public static Weights of(double[] perChannel) {
        return new Weights(null, perChannel.length, perChannel);
    }

    /** The weight of a face's channel, m²/W. */
    public double at(int face, int channel) {
        return value[at(rooms, face, channel, channels, value.length)];
    }

    /** Index of the weight of a face's channel in an array of {@code count} weights. */
    public static int at(ClosedRooms rooms, int face, int channel, int channels, int count) {
        return count == channels ? channel : channels * (rooms.room(face) + 1) + channel;
    }
}
