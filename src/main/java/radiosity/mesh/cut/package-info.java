/**
 * Faces cut where other triangles stand on them or come through them (discontinuity meshing).
 */
package radiosity.mesh.cut;
