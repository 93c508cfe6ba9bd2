package radiosity.mesh.room;

import java.util.Arrays;

/** Groups of faces: lists the members of a group without a search through all faces. */
final class FaceGroups {

    /** 1 per group: the end of its members in {@link #members}; they begin at the end of the group before. */
    private final int[] ends;
    private final int[] members;

    /** @param group 1 per face: the number of its group, at least 0 and below the number of faces; not modified */
    FaceGroups(int[] group) {
        int n = group.length;
        int[] place = new int[n + 1];
        for (int g : group) {
            place[g + 1]++;
        }
        for (int g = 0; g < n; g++) {
            place[g + 1] += place[g];
        }
        members = new int[n];
        for (int f = 0; f < n; f++) {
            members[place[group[f]]++] = f;
        }
        ends = Arrays.copyOf(place, n);
    }

    /** The faces of a group, ascending. */
    int[] of(int group) {
        return Arrays.copyOfRange(members, group == 0 ? 0 : ends[group - 1], ends[group]);
    }
}
