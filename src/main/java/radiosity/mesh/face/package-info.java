/**
 * The radiating sides of the triangles, brought to size 1: neighbours, coplanar regions, materials.
 *
 * <p>Lengths in this package are in scene sizes unless a comment says otherwise, see {@link radiosity.mesh.face.Faces}.
 */
package radiosity.mesh.face;
