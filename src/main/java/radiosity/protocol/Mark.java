package radiosity.protocol;

/**
 * A node of the mesh that is to be divided, with all nodes above it, whatever its vertices have received.
 *
 * @param face face of the node
 * @param path path of the node below its face, see {@link radiosity.mesh.face.NodePath}
 */
public record Mark(int face, long path) { }
