package radiosity.mesh;

import radiosity.mesh.face.NodePath;

/**
 * Neighbouring subtrees of the patch tree that have one owner: the unit of ownership, movement, checkpoint and replay.
 *
 * @param id   place of the block in the geometric order of the scene's blocks
 * @param face 1 per subtree: the face on which the subtree lies
 * @param path 1 per subtree: path of its top node below the face, see {@link NodePath}
 */
public record Block(int id, int[] face, long[] path) { }
