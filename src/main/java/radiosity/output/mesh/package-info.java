/**
 * The solution as a mesh: shared vertices, cracks closed, elements found by place.
 */
package radiosity.output.mesh;
