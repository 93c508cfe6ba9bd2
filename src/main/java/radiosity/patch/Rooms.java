package radiosity.patch;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * Which faces stand in a room that is proven closed: from every point of it surfaces are seen in all directions, by
 * their radiating sides.
 *
 * <p>A shell is what is connected by edges; it is whole where every edge is run through as often in one direction as in
 * the other, so that as a chain it has no boundary; corners of others may stand on an edge. A whole shell seen from inside is the wall of a room; the room is
 * closed if whatever else reaches into its box is whole or stands on a wall, is seen from outside, and with each face either in it or out of it.
 * A hairline opening leaves a boundary.
 */
public final class Rooms {

    /** Boxes that overlap by less do not, of the scene's size. */
    private static final double TOUCH = 1e-6;
    /** How far before a face it is asked where it stands, of the scene's size. */
    private static final double BEFORE = 1e-5;
    /** Faces of solids times faces of walls that are looked at; what would take more counts as open. */
    private static final long MOST_PAIRS = 5_000_000;
    private static final int PLACES = 4;

    private final Faces faces;
    private final Shells shells;
    /** 1 per face: the lowest face of its shell. */
    private final int[] shell;
    private final boolean[] open;
    /** 1 per lowest face: volume, of the scene's cubed size; negative where it is seen from inside. */
    private final double[] volume;
    /** 6 per lowest face: low x, y, z, high x, y, z. */
    private final float[] box;
    private final int[] room;
    /** 1 per lowest face: whether all of the shell are buried pieces that look at backs. */
    private final boolean[] hidden;
    private int count;
    private final boolean plain;

    public Rooms(Faces faces) {
        this(faces, f -> false);
    }

    /** @param buried whether nothing but backs is seen from a face */
    public Rooms(Faces faces, IntPredicate buried) {
        this.faces = faces;
        int n = faces.count();
        shells = new Shells(faces);
        shell = shells.shell;
        open = shells.open;
        volume = new double[n];
        box = new float[6 * n];
        room = new int[n];
        hidden = new boolean[n];
        Arrays.fill(room, -1);
        measure();
        for (int f = 0; f < n; f++) {
            if (shell[f] == f && isWall(f) && isClosed(f)) {
                furnish(f);
            }
            hidden[f] = shells.seesBacks[f] && IntStream.of(of(f)).allMatch(g -> faces.isPiece(g) && buried.test(g));
        }
        plain = findPlain();
    }

    /** The number of the closed room in which a face stands, or -1. */
    public int room(int face) {
        return room[face];
    }

    /** Whether a face is a piece that lies under what stands on its triangle. */
    public boolean isHidden(int face) {
        return room[face] < 0 && hidden[shell[face]];
    }

    /** Whether all faces stand in one closed room, and no two shells touch: nothing is covered. */
    public boolean isPlain() {
        return plain;
    }

    private boolean findPlain() {
        for (int f = 0; f < shell.length; f++) {
            if (room[f] != 0 && !isHidden(f) || room[f] == 0 && open[shell[f]]) {
                return false;
            }
            for (int g = 0; g < f && shell[f] == f && volume[f] >= 0; g++) {
                if (shell[g] == g && volume[g] >= 0 && overlap(f, g, -TOUCH)) {
                    return false;
                }
            }
        }
        return count == 1;
    }

    /** Number of closed rooms. */
    public int count() {
        return count;
    }

    private void measure() {
        for (int f = 0; f < shell.length; f++) {
            int s = shell[f];
            if (s == f) {
                Arrays.fill(box, 6 * s, 6 * s + 3, Float.POSITIVE_INFINITY);
                Arrays.fill(box, 6 * s + 3, 6 * s + 6, Float.NEGATIVE_INFINITY);
            }
            for (int i = 0; i < 9; i++) {
                float x = faces.corner[9 * f + i];
                box[6 * s + i % 3] = Math.min(box[6 * s + i % 3], x);
                box[6 * s + 3 + i % 3] = Math.max(box[6 * s + 3 + i % 3], x);
            }
            double[] c = corners(f, 0, 0, 0);
            volume[s] += triple(c) / 6;
        }
    }

    /** Corners of a face as seen from a place. */
    private double[] corners(int f, double x, double y, double z) {
        double[] c = new double[9];
        for (int i = 0; i < 9; i++) {
            c[i] = faces.corner[9 * f + i] - (i % 3 == 0 ? x : i % 3 == 1 ? y : z);
        }
        return c;
    }

    private static double triple(double[] c) {
        return c[0] * (c[4] * c[8] - c[5] * c[7]) + c[1] * (c[5] * c[6] - c[3] * c[8])
                + c[2] * (c[3] * c[7] - c[4] * c[6]);
    }

    private boolean isWall(int s) {
        return !open[s] && volume[s] < 0;
    }

    /** Whether all that reaches into a shell's box is solid. */
    private boolean isClosed(int wall) {
        for (int s = 0; s < shell.length; s++) {
            if (s != wall && shell[s] == s && overlap(wall, s, TOUCH) && !isSolid(s, wall)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Seen from outside, and whole or standing on a wall with what it lacks. Or a piece of a triangle that lies wholly
     * outside, behind what stands on the triangle.
     */
    private boolean isSolid(int s, int wall) {
        if (shells.seesBacks[s]) {
            int[] walls = of(wall);
            return IntStream.of(of(s)).allMatch(f -> faces.isPiece(f) && inside(f, walls) == 0);
        }
        return open[s] ? new Footprint(faces, shell, s, shells.rims.get(s)).isOn(wall) : volume[s] >= 0;
    }

    private int[] of(int s) {
        return IntStream.range(0, shell.length).filter(f -> shell[f] == s).toArray();
    }

    private boolean overlap(int s, int t, double by) {
        for (int a = 0; a < 3; a++) {
            if (box[6 * s + a] > box[6 * t + 3 + a] - by || box[6 * t + a] > box[6 * s + 3 + a] - by) {
                return false;
            }
        }
        return true;
    }

    /** Gives a wall and the solids in it the number of a room, unless a face is neither in it nor out of it. */
    private void furnish(int wall) {
        int[] walls = of(wall);
        int[] others = IntStream.range(0, shell.length).filter(f -> shell[f] != wall && overlap(wall, shell[f], TOUCH)).toArray();
        int[] inside = new int[shell.length];
        boolean clear = (long) walls.length * others.length <= MOST_PAIRS;
        for (int i = 0; i < others.length && clear; i++) {
            int f = others[i];
            inside[f] = inside(f, walls);
            clear = inside[f] % PLACES == 0 && (faces.part[f] == f || inside[faces.part[f]] == inside[f]);
        }
        if (clear) {
            for (int f = 0; f < shell.length; f++) {
                room[f] = shell[f] == wall || inside[f] > 0 ? count : room[f];
            }
            count++;
        }
    }

    /** How many of a few places before a face are inside a shell: its middle, and near its corners. */
    private int inside(int face, int[] walls) {
        int found = 0;
        for (int place = 0; place < PLACES; place++) {
            double[] at = new double[3];
            for (int a = 0; a < 3; a++) {
                for (int k = 0; k < 3; k++) {
                    double weight = place == 3 ? 1 / 3.0 : place == k ? 0.9 : 0.05;
                    at[a] += weight * faces.corner(face, k, a);
                }
                at[a] += BEFORE * faces.normal(face, a);
            }
            found += isInside(at, walls) ? 1 : 0;
        }
        return found;
    }

    /**
     * Whether a place is inside a shell: by the solid angle that this fills, seen from there. A. van Oosterom,
     * J. Strackee, The solid angle of a plane triangle, 1983.
     */
    private boolean isInside(double[] at, int[] walls) {
        double angle = 0;
        for (int f : walls) {
            double[] c = corners(f, at[0], at[1], at[2]);
            double p = length(c, 0);
            double q = length(c, 3);
            double r = length(c, 6);
            double below = p * q * r + dot(c, 0, 3) * r + dot(c, 3, 6) * p + dot(c, 6, 0) * q;
            angle += 2 * StrictMath.atan2(triple(c), below);
        }
        return angle < -2 * Math.PI;
    }

    private static double length(double[] c, int i) {
        return Math.sqrt(dot(c, i, i));
    }

    private static double dot(double[] c, int i, int j) {
        return c[i] * c[j] + c[i + 1] * c[j + 1] + c[i + 2] * c[j + 2];
    }
}
