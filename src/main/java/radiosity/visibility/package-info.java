/**
 * What stands between two points: a bounding volume hierarchy over the triangles (sections 2.4.1 and 4.5.9 of the
 * paper).
 *
 * <p>The hierarchy sees corners in arrays, never a surface. It is made once and then only read, by any number of
 * threads.
 */
package radiosity.visibility;
