package radiosity.scene;

/**
 * A node of a scene's hierarchy: an object, a group, or a node that only places its children.
 *
 * @param name      name in the input, perhaps empty, perhaps the name of other nodes too
 * @param parent    index of the parent node, lower than the node's own index; -1 for none
 * @param geometry  name of the mesh or file of the node's triangles, equal for all instances; empty for a node without
 *                  any
 * @param placement from the node's own space to its parent's, right-handed
 */
public record SceneNode(String name, int parent, String geometry, Affine placement) {
}
