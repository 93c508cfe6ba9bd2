package radiosity.lightwave;

/** Texture coordinates of one name for points of a layer (VMAP), or for corners of its polygons (VMAD). */
final class VertexMap {

    final String name;
    final Ints points = new Ints();
    /** Per entry; none in a map of points. */
    final Ints polygons = new Ints();
    /** u, v of each entry. */
    final Floats values = new Floats();

    VertexMap(String name) {
        this.name = name;
    }
}
