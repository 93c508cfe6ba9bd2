package radiosity.mesh;

import radiosity.mesh.room.ClosedRooms;

/**
 * What a W/m² counts for where it is decided how closely to look: one over the mean of its channel, so that all
 * channels are as exact. Closed rooms send each other nothing, so where there are several each has its own: a dim one
 * beside one that is brighter by far is as exact as it is alone.
 *
 * @param rooms    which faces stand in which room
 * @param channels of the light
 * @param value    one per channel, m²/W; where rooms differ for what stands in none, then for each room
 */
public record Weights(ClosedRooms rooms, int channels, double[] value) {

    /** How many there are to be for a scene. */
    public static int count(ClosedRooms rooms, int channels) {
        return rooms.count() > 1 ? channels * (1 + rooms.count()) : channels;
    }

    /** The same everywhere. */
    public static Weights of(double[] perChannel) {
        return new Weights(null, perChannel.length, perChannel);
    }

    /** Of a face. */
    public double at(int face, int channel) {
        return value[at(rooms, face, channel, channels, value.length)];
    }

    /** Where the value of a face's channel stands among all. */
    public static int at(ClosedRooms rooms, int face, int channel, int channels, int count) {
        return count == channels ? channel : channels * (rooms.room(face) + 1) + channel;
    }
}
