package radiosity.input.lightwave.lwo;

import radiosity.input.file.FloatList;
import radiosity.input.file.IntList;

/** Texture coordinates of one name for points of a layer (VMAP), or for corners of its polygons (VMAD). */
final class VertexMap {

    final String name;
    final IntList points = new IntList();
    /** Polygon of each entry of a VMAD; empty in a VMAP. */
    final IntList polygons = new IntList();
    /** u, v of each entry. */
    final FloatList values = new FloatList();

    VertexMap(String name) {
        this.name = name;
    }
}
