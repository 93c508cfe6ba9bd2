/**
 * Finds the faces that stand in a room that is proven closed.
 */
package radiosity.mesh.room;
