package radiosity.scene;

/**
 * A place in the hierarchy that the scene's maker gave it: an object, a group, or a place that holds others.
 *
 * @param name      as the input has it, perhaps empty, perhaps that of other nodes too
 * @param parent    index of the node that this one belongs to, lower than its own; -1 for none
 * @param geometry  what stands here, equal for all instances of it: name of a mesh, or of a file; empty for a node that
 *                  only places others
 * @param placement from the node's own space to its parent's, right-handed
 */
public record SceneNode(String name, int parent, String geometry, Affine placement) {
}
