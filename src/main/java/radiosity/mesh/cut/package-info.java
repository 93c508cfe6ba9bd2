/**
 * Cuts triangles before they are meshed: long quadrangles across, triangles at T-vertices on their edges, and faces
 * where other triangles stand on them or pass through them (discontinuity meshing).
 */
package radiosity.mesh.cut;
