/**
 * What all readers end with: meshes placed as a scene's triangles, within limits of number and memory, under the nodes
 * of the input.
 *
 * <p>One reader fills a {@link radiosity.input.assembly.SceneDraft}, which makes one scene.
 */
package radiosity.input.assembly;
