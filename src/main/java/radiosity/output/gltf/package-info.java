/**
 * The scene file, a glTF 2.0 binary: written, read and described.
 *
 * <p>Starts from a {@link radiosity.solution.Solution} and changes nothing in it.
 */
package radiosity.output.gltf;
