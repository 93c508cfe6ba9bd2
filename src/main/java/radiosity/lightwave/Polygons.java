package radiosity.lightwave;

/**
 * Polygons as a file lists them, in arrays.
 *
 * <p>A polygon of a kind that is not taken stays in the list without corners, as others are numbered after it.
 */
final class Polygons {

    /** Surface number of a polygon that names none. */
    static final int UNTAGGED = -1;

    private final Ints ends = new Ints();
    private final Ints corners = new Ints();
    private final Ints tags = new Ints();

    /** Adds a corner of the polygon that the next {@link #close} makes. */
    void corner(int point) {
        corners.add(point);
    }

    /** Ends the polygon of the corners added since the last one; {@code tag} is its surface's number. */
    void close(int tag) {
        ends.add(corners.size());
        tags.add(tag);
    }

    /** Ends it without its corners. */
    void closeEmpty() {
        corners.cut(size() == 0 ? 0 : ends.get(size() - 1));
        close(UNTAGGED);
    }

    int size() {
        return ends.size();
    }

    /** Index of the first corner of a polygon among all corners. */
    int start(int polygon) {
        return polygon == 0 ? 0 : ends.get(polygon - 1);
    }

    int end(int polygon) {
        return ends.get(polygon);
    }

    /** The point at one of all corners. */
    int point(int corner) {
        return corners.get(corner);
    }

    int tag(int polygon) {
        return tags.get(polygon);
    }

    void tag(int polygon, int tag) {
        tags.set(polygon, tag);
    }
}
