package radiosity.mesh;

import radiosity.mesh.room.ClosedRooms;

/**
 * An even light in closed rooms: a radiosity that all surfaces of a room have in common.
 *
 * <p>In a closed room form factors add up to 1, so even light arrives as it left, and needs no rays. What is gathered
 * by rays is only by how much surfaces differ from it. Rays that miss a thousandth of everything would make a room of
 * reflectance .9999 lose its light; they may well miss a thousandth of a difference.
 *
 * @param rooms which faces stand in which room
 * @param level channels per room, W/m²
 */
public record UniformRadiosity(ClosedRooms rooms, int channels, double[] level) {

    /** Of a face; 0 where its room is not closed. */
    public double at(int face, int channel) {
        int room = level.length == 0 ? -1 : rooms.room(face);
        return room < 0 ? 0 : level[channels * room + channel];
    }

    public boolean isDark() {
        for (double l : level) {
            if (l != 0) {
                return false;
            }
        }
        return true;
    }
}
