/**
 * Finds the faces that stand in a room that is proven closed, and those that no light reaches inside of closed bodies.
 */
package radiosity.mesh.room;
