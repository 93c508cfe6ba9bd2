/**
 * Polygons of any shape cut into triangles (shared by all readers).
 */
package radiosity.input.polygon;
