package radiosity.mesh;

import radiosity.mesh.room.ClosedRooms;

/**
 * A uniform part of the light in closed rooms: a radiosity that all surfaces of a room have in common.
 *
 * <p>In a closed room form factors add up to 1, so uniform radiosity arrives undiminished and needs no rays. Rays
 * gather only the difference of each surface from the uniform part. Rays that miss a thousandth of all light would make
 * a room of reflectance 0.9999 lose its light; missing a thousandth of a difference is harmless.
 *
 * @param rooms which faces stand in which closed room; may be null where {@code level} is empty
 * @param level channels per room, W/m²; empty: no uniform part
 */
public record UniformRadiosity(ClosedRooms rooms, int channels, double[] level) {

    /** The uniform radiosity of a face's room, W/m²; 0 for a face in no closed room. */
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
