/**
 * The solution as a mesh: shared vertices, closed cracks, elements found by position.
 */
package radiosity.output.mesh;
