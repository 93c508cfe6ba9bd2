package radiosity.input.polygon;

import radiosity.input.file.IntList;

/**
 * Polygons as a file lists them, in arrays.
 *
 * <p>A polygon of a kind that is not read stays in the list without corners, as the file numbers later polygons after
 * it.
 */
public final class Polygons {

    /** Surface number of a polygon that names no surface. */
    public static final int UNTAGGED = -1;

    private final IntList ends = new IntList();
    private final IntList corners = new IntList();
    private final IntList tags = new IntList();

    /** Adds a corner, at the point with an index, to the polygon that the next {@link #close} ends. */
    public void corner(int point) {
        corners.add(point);
    }

    /** Ends the polygon, whose corners are those added since the last end; {@code tag} is the number of its surface. */
    public void close(int tag) {
        ends.add(corners.size());
        tags.add(tag);
    }

    /** Ends the polygon and drops its corners. */
    public void closeEmpty() {
        corners.cut(size() == 0 ? 0 : ends.get(size() - 1));
        close(UNTAGGED);
    }

    public int size() {
        return ends.size();
    }

    /** Index of the first corner of a polygon among all corners. */
    public int start(int polygon) {
        return polygon == 0 ? 0 : ends.get(polygon - 1);
    }

    public int end(int polygon) {
        return ends.get(polygon);
    }

    /** Index of the point at a corner, which is an index among all corners. */
    public int point(int corner) {
        return corners.get(corner);
    }

    public int tag(int polygon) {
        return tags.get(polygon);
    }

    public void tag(int polygon, int tag) {
        tags.set(polygon, tag);
    }
}
