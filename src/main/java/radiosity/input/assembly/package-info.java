/**
 * What all readers end with: meshes placed as a scene's triangles, within limits of number and memory, under the nodes
 * of the input.
 *
 * <p>{@link radiosity.input.assembly.SceneDraft} is filled by one reader and makes one scene.
 */
package radiosity.input.assembly;
