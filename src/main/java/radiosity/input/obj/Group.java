package radiosity.input.obj;

import radiosity.input.file.IntList;
import radiosity.input.polygon.Polygons;

/**
 * The polygons of an object, or of a group in an object.
 *
 * @param node     index of its node in the scene
 * @param place    line in the file where it begins, for messages
 * @param polygons corners are indices of the file's vertices, tags are indices of materials
 * @param textures index of the texture vertex of each corner, or -1
 * @param normals  index of the normal of each corner, or -1
 * @param smooth   smoothing group of each polygon; 0 for none
 * @param lines    line of each polygon in the file
 */
record Group(int node, String place, Polygons polygons, IntList textures, IntList normals, IntList smooth,
             IntList lines) {

    Group(int node, String place) {
        this(node, place, new Polygons(), new IntList(), new IntList(), new IntList(), new IntList());
    }
}
