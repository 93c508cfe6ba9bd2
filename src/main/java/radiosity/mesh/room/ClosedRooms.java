package radiosity.mesh.room;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.util.BoxTree;

/**
 * Finds the faces that stand in a room that is proven closed: from every point of such a room the radiating sides of
 * surfaces are seen in all directions.
 *
 * <p>A shell is a set of faces connected across edges. A shell is whole where every edge is used as often in one
 * direction as in the other, so that the shell has no boundary; corners of other faces may stand on an edge. A whole
 * shell that is seen from inside is the wall of a room. The room is closed if every other shell that reaches into the
 * box of the wall is whole or stands on a wall, is seen from outside, and has each face either inside or outside of the
 * room. Even a hairline opening leaves a boundary.
 */
public final class ClosedRooms {

    /** Boxes that overlap by less than this are apart, in scene sizes. */
    private static final double TOUCH = 1e-6;
    /** Most pairs of a face of a solid and a face of a wall that are tested; a room with more pairs counts as open. */
    private static final long MOST_PAIRS = 5_000_000;

    private final Faces faces;
    private final FaceShells shells;
    /** 1 per face: the lowest face of its shell. */
    private final int[] shell;
    private final boolean[] open;
    private final double[] volume;
    private final double[] box;
    private final int[] room;
    private final FaceGroups members;
    private final FaceGroups parts;
    private final ShellBoxes all;
    /** Boxes of whole shells seen from inside: a wall is never closed where another of these overlaps its box. */
    private final ShellBoxes inward;
    /** Boxes of open shells, which may count as solid if they stand on a wall. */
    private final ShellBoxes doubtful;
    /** Number of pairs of shells and of faces that were tested; read by tests. */
    public long looks;
    /** 1 per lowest face: whether the shell sees backs and consists of buried pieces only. */
    private final boolean[] hidden;
    private final BitSet covered;
    private int count;
    private final boolean plain;

    /**
     * @param buried  whether every surface that is seen from a face shows its back
     * @param covered faces that other faces in the same place cover, which are in no room; not modified, kept
     */
    public ClosedRooms(Faces faces, IntPredicate buried, BitSet covered) {
        this.faces = faces;
        this.covered = covered;
        int n = faces.count();
        shells = new FaceShells(faces);
        shell = shells.shell;
        open = shells.open;
        volume = shells.volume;
        box = shells.box;
        room = new int[n];
        hidden = new boolean[n];
        Arrays.fill(room, -1);
        members = new FaceGroups(shell);
        parts = new FaceGroups(faces.part);
        all = new ShellBoxes(IntStream.range(0, n).filter(f -> shell[f] == f).toArray());
        inward = new ShellBoxes(IntStream.range(0, n).filter(f -> shell[f] == f && isWall(f)).toArray());
        doubtful = new ShellBoxes(IntStream.range(0, n).filter(f -> shell[f] == f && open[f]).toArray());
        int[] insideOf = new int[n];
        for (int f = 0; f < n; f++) {
            if (shell[f] == f && isWall(f) && isClosed(f)) {
                assignRoom(f, insideOf);
            }
            hidden[f] = shells.seesBacks[f] && IntStream.of(members.of(f))
                    .allMatch(g -> faces.isPiece(g) && buried.test(g));
        }
        covered.stream().forEach(f -> room[f] = -1);
        plain = findPlain();
    }

    /** The number of the closed room in which a face stands, or -1. */
    public int room(int face) {
        return room[face];
    }

    /**
     * Whether a face is a piece of a triangle that lies under another object which stands on the triangle, or another
     * face in the same place covers the face.
     */
    public boolean isHidden(int face) {
        return isCovered(face) || room[face] < 0 && hidden[shell[face]];
    }

    /** Whether another face in the same place covers a face. */
    public boolean isCovered(int face) {
        return covered.get(face);
    }

    /** Whether all faces but hidden ones stand in one closed room of whole shells, and no two solids touch. */
    public boolean isPlain() {
        return plain;
    }

    private boolean findPlain() {
        if (count != 1) {
            return false;
        }
        for (int f = 0; f < shell.length; f++) {
            if (room[f] != 0 && !isHidden(f) || room[f] == 0 && open[shell[f]]) {
                return false;
            }
            if (shell[f] == f && volume[f] >= 0 && all.any(f, -TOUCH, other -> volume[other] >= 0)) {
                return false;
            }
        }
        return true;
    }

    /** Boxes of some shells in a tree, which finds the boxes that overlap a shell's without testing all. */
    private final class ShellBoxes {

        private final int[] some;
        private final BoxTree tree;

        /** @param some lowest faces of shells; not modified, kept */
        ShellBoxes(int[] some) {
            this.some = some;
            double[] boxes = new double[6 * some.length];
            for (int i = 0; i < boxes.length; i++) {
                boxes[i] = box[6 * some[i / 6] + i % 6];
            }
            tree = new BoxTree(boxes);
        }

        /** Whether a wanted shell other than s has a box that overlaps the box of s by {@code by} on every axis. */
        boolean any(int s, double by, IntPredicate wanted) {
            BoxTree.Region overlapping = BoxTree.overlapping(box, 6 * s, by);
            BoxTree.Region region = (boxes, i) -> {
                looks++;
                return overlapping.meets(boxes, i);
            };
            return tree.any(region, i -> some[i] != s && wanted.test(some[i]));
        }
    }

    /** Number of closed rooms. */
    public int count() {
        return count;
    }

    private boolean isWall(int s) {
        return !open[s] && volume[s] < 0;
    }

    /** Whether every shell that reaches into the box of a wall is solid; another wall never is. */
    private boolean isClosed(int wall) {
        return !inward.any(wall, TOUCH, s -> true) && !doubtful.any(wall, TOUCH, s -> !isSolid(s, wall));
    }

    /**
     * Whether a shell is seen from outside, and whole or standing on a wall with its rim; or consists of pieces that
     * lie outside the wall, behind an object that stands on their triangle.
     */
    private boolean isSolid(int s, int wall) {
        if (shells.seesBacks[s]) {
            int[] walls = members.of(wall);
            return IntStream.of(members.of(s)).allMatch(f -> faces.isPiece(f) && inside(f, walls) == 0);
        }
        return open[s] ? new Footprint(faces, parts, members.of(s), shells.rims.get(s)).isOn(members.of(wall))
                : volume[s] >= 0;
    }

    /**
     * Gives the faces of a wall and the faces in it the number of a new room, unless one is partly in and partly out.
     *
     * @param inside scratch, 1 per face: 0 before and after the call
     */
    private void assignRoom(int wall, int[] inside) {
        int[] walls = members.of(wall);
        IntStream.Builder near = IntStream.builder();
        all.any(wall, -TOUCH, s -> {
            IntStream.of(members.of(s)).forEach(near);
            return false;
        });
        int[] others = near.build().sorted().toArray();
        boolean clear = (long) walls.length * others.length <= MOST_PAIRS;
        for (int i = 0; i < others.length && clear; i++) {
            int f = others[i];
            inside[f] = inside(f, walls);
            clear = inside[f] % SolidAngle.PLACES == 0 && (faces.part[f] == f || inside[faces.part[f]] == inside[f]);
        }
        if (clear) {
            for (int f : walls) {
                room[f] = count;
            }
            for (int f : others) {
                room[f] = inside[f] > 0 ? count : room[f];
            }
            count++;
        }
        for (int f : others) {
            inside[f] = 0;
        }
    }

    /** The number of points in front of a face, its middle and a point near each corner, that lie inside a shell. */
    private int inside(int face, int[] walls) {
        looks += walls.length;
        int found = 0;
        for (int place = 0; place < SolidAngle.PLACES; place++) {
            found += SolidAngle.isInside(faces, SolidAngle.before(faces, face, place), walls) ? 1 : 0;
        }
        return found;
    }
}
