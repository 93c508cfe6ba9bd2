/**
 * The radiating sides of the triangles, brought to size 1: neighbours, coplanar regions, materials.
 *
 * <p>Lengths here are relative to the scene's size, see {@link radiosity.mesh.face.Faces}.
 */
package radiosity.mesh.face;
