/**
 * Cuts faces where other triangles stand on them or pass through them (discontinuity meshing).
 */
package radiosity.mesh.cut;
