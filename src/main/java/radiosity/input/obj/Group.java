package radiosity.input.obj;

import radiosity.input.file.IntList;
import radiosity.input.polygon.Polygons;

/**
 * The polygons of an object, or of a group in it.
 *
 * @param node     index of its node
 * @param place    where it begins in the file, for messages
 * @param polygons corners are vertices of the file, tags are numbers of materials
 * @param textures which texture vertex each corner has, or -1
 * @param lines    line of each polygon
 */
record Group(int node, String place, Polygons polygons, IntList textures, IntList lines) {

    Group(int node, String place) {
        this(node, place, new Polygons(), new IntList(), new IntList());
    }
}
