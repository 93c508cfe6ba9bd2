/**
 * Visibility between two points, by a bounding volume hierarchy over the triangles (sections 2.4.1 and 4.5.9 of the
 * paper).
 *
 * <p>The hierarchy is made from arrays of corners and knows no surfaces. After construction it is only read, by any
 * number of threads.
 */
package radiosity.visibility;
